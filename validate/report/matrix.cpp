#include "validate/report/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "validate/compare/difference_code.h"
#include "validate/renderers/entry.h"
#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

using Json = nlohmann::ordered_json;

bool was_drawn(const Judged& judged) { return judged.drawn.status == RenderedShot::Status::kDrawn; }

/// A button of the matrix; `shot` is "coverage" or a shot's number.
PageData cell_data(const std::string& shot, std::string_view outcome, const std::string& name,
                   bool drawn) {
  PageData cell;
  cell.set("shot", shot);
  cell.set("outcome", std::string(outcome));
  cell.set("name", name);
  cell.set("drawn", drawn);
  return cell;
}

PageData row_cells(const Validation& v, const RendererResult& result) {
  const std::string& renderer = result.rendering.renderer;
  PageData cells(PageData::type::list);
  cells.push_back(
      cell_data("coverage", coverage_outcome(result), renderer + ", coverage", result.drew_any()));
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    const Judged& judged = result.shots[s];
    cells.push_back(cell_data(std::to_string(s), outcome(judged),
                              renderer + ", " + shot_title(v.shots[s]), was_drawn(judged)));
  }
  return cells;
}

PageData own_cells(const Validation& v) {
  PageData cells(PageData::type::list);
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    PageData cell;
    cell.set("shot", std::to_string(s));
    cell.set("title", shot_title(v.shots[s]));
    cell.set("url", picture_url(v.own_pictures[s].display));
    cells.push_back(cell);
  }
  return cells;
}

/// A picture as a URL: null if there is none.
Json url_json(const std::string& png) { return png.empty() ? Json() : Json(picture_url(png)); }

/// Null if there is none.
Json coded_json(const CodedDifference& coded) {
  if (coded.png.empty()) return {};
  return {{"url", picture_url(coded.png)}, {"step", coded.step}, {"block", coded.block}};
}

Json cell_json(const Judged& judged) {
  Json cell{{"outcome", outcome(judged)}, {"why", judged.drawn.why}, {"note", judged.drawn.note}};
  if (!was_drawn(judged)) return cell;
  const Pictures& pictures = judged.pictures;
  const Comparison& c = judged.comparison;
  cell["difference"] = coded_json(pictures.difference);
  cell["marks"] = picture_url(pictures.marks);
  cell["flip"] = url_json(pictures.flip);
  cell["meanFlip"] = pictures.mean_flip;
  cell["instead"] = url_json(pictures.instead.display);
  cell["insteadExcess"] = coded_json(pictures.instead.excess);
  cell["max"] = c.max;
  cell["exceeded"] = c.exceeded;
  return cell;
}

/// The shot whose coverage differs most.
std::size_t coverage_shot(const RendererResult& result) {
  const auto most = std::ranges::max_element(result.shots, {}, [](const Judged& judged) {
    return was_drawn(judged) ? judged.comparison.coverage_differs : -1;
  });
  return std::size_t(most - result.shots.begin());
}

Json viewed_renderer_json(const RendererResult& result) {
  const std::optional<double>& stated = result.limits.max;  // else each pixel has its own limit
  Json cells = Json::array();
  for (const Judged& judged : result.shots) cells.push_back(cell_json(judged));
  return {{"name", result.rendering.renderer},
          {"limited", result.rendering.limited},
          {"limit", stated ? Json(*stated) : Json()},
          {"coverage", {{"outcome", coverage_outcome(result)}, {"shot", coverage_shot(result)}}},
          {"cells", cells}};
}

Json viewed_shots_json(const Validation& v) {
  Json shots = Json::array();
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    shots.push_back({{"title", shot_title(v.shots[s])},
                     {"final", v.shots[s].stage == Stage::kFinal},
                     {"excess", coded_json(v.own_pictures[s].excess)}});
  }
  return shots;
}

}  // namespace

std::string shot_title(const Shot& shot) {
  return shot.stage == Stage::kFinal ? shot.name : shot.name + " alone";
}

void set_matrix(const Validation& v, PageData& page) {
  page.set("stages", page_list(v.shots, [](const Shot& shot) {
             PageData stage;
             stage.set("name", shot.name);
             return stage;
           }));
  page.set("own_cells", own_cells(v));
  int number = 0;
  page.set("matrix", page_list(v.results, [&](const RendererResult& result) {
             PageData row;
             row.set("number", std::to_string(number++));
             row.set("renderer", result.rendering.renderer);
             row.set("renderer_outcome", std::string(renderer_outcome(result)));
             row.set("cells", row_cells(v, result));
             return row;
           }));
}

std::string viewer_json(const Validation& v) {
  const Image& image = v.own.shots.front().image;
  const int block = page_block(image.width, image.height);
  Json renderers = Json::array();
  for (const RendererResult& result : v.results) {
    renderers.push_back(viewed_renderer_json(result));
  }
  const Json json{{"block", block},
                  {"bend", kCodeBend},
                  {"flipFrom", kFlipFrom},
                  {"markNames", kPixelMarkNames},
                  {"cover", picture_url(v.own_cover)},
                  {"shots", viewed_shots_json(v)},
                  {"renderers", renderers}};
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // A script element ends at the first "</script", wherever it stands.
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

}  // namespace lumaknot::validate
