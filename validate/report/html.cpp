#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "validate/renderers/entry.h"
#include "validate/report/forms.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view report_template();
}  // namespace lumaknot::embedded

namespace lumaknot::validate {
namespace {

using Data = PageData;

/// The text of a limit; empty without one.
std::string limit_text(std::string_view name, double limit) {
  return std::isfinite(limit) ? fmt::format("{} ≤ {:g}, ", name, limit) : "";
}

std::string limits_text(const Limits& l) {
  return fmt::format(
      "edges within {:.3g} pixel, {}{}{}errors above {:g} need a class, unexplained ≤ {:g} % of "
      "the "
      "silhouette. {}",
      l.edge, limit_text("mean", l.mean), limit_text("p99.9", l.p999),
      limit_text("p99.99", l.p9999), l.outlier, 100 * l.unexplained, l.reason);
}

std::string details(const Judged& judged) {
  const Comparison& c = judged.comparison;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < c.classes.size(); ++i) {
    if (c.classes[i]) parts.push_back(fmt::format("{} {}", c.classes[i], kPixelClassNames[i]));
  }
  for (const ClassShare& share : c.shares) {
    if (share.exceeded) parts.push_back("beyond what is allowed: " + share_text(share));
  }
  for (const std::string& line : c.exceeded) parts.push_back("exceeded: " + line);
  for (const std::string& line : {judged.drawn.why, judged.drawn.note}) {
    if (!line.empty()) parts.push_back(line);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

Data row_data(const Shot& shot, const std::string& renderer, const Judged& judged) {
  const Comparison& c = judged.comparison;
  const auto number = [](double x) { return fmt::format("{:.2e}", x); };
  Data row;
  row.set("shot", shot.name);
  row.set("renderer", renderer);
  row.set("outcome", std::string(outcome(judged)));
  row.set("drawn", judged.drawn.status == RenderedShot::Status::kDrawn);
  row.set("coverage", fmt::format("{} of {}", c.coverage_differs, c.covered));
  row.set("mean", number(c.mean));
  row.set("rmse", number(c.rmse));
  row.set("p99", number(c.p99));
  row.set("p999", number(c.p999));
  row.set("max", number(c.max));
  row.set("judged", fmt::format("{:.2e}, {:.2e}", c.mean_unclassed, c.p999_unclassed));
  row.set("max_at", fmt::format("{}, {}", c.max_at.x, c.max_at.y));
  row.set("outliers", std::to_string(c.outliers));
  row.set("details", details(judged));
  return row;
}

Data claims_data(const Shot& shot, const std::string& renderer, const Claims& claims) {
  Data row;
  row.set("shot", shot.name);
  row.set("renderer", renderer);
  row.set("pixels", std::to_string(claims.highlight_pixels));
  row.set("chroma", fmt::format("{:.4f}", claims.highlight_chroma));
  row.set("hue", fmt::format("{:.2f}", claims.hue_shift_degrees));
  row.set("zero", fmt::format("{:.1f}", 100 * claims.clipped_at_zero));
  row.set("one", fmt::format("{:.1f}", 100 * claims.clipped_at_one));
  return row;
}

Data renderers_data(const Validation& v) {
  return page_list(v.results, [](const RendererResult& result) {
    const Rendering& r = result.rendering;
    Data row;
    row.set("name", r.renderer);
    row.set("version", r.version.empty() ? "not run" : r.version);
    row.set("seconds", fmt::format("{:.2f}", r.seconds));
    row.set("limits", limits_text(renderer_entry(r.renderer).limits));
    if (!r.command.empty()) row.set("command", fmt::format("{}", fmt::join(r.command, " ")));
    return row;
  });
}

Data coverage_row(const RendererResult& result) {
  Data row;
  row.set("shot", "coverage");
  row.set("renderer", result.rendering.renderer);
  row.set("outcome", std::string(coverage_outcome(result)));
  row.set("drawn", result.drew_any());
  row.set("coverage", fmt::format("{} of {}", result.coverage_differs,
                                  result.shots.front().comparison.covered));
  if (result.coverage_differs > 0) {
    row.set("details", fmt::format("{} where an edge passes by the sample, {} unexplained",
                                   result.coverage_differs - result.coverage_unexplained,
                                   result.coverage_unexplained));
  }
  return row;
}

Data comparison_rows(const Validation& v) {
  Data list(Data::type::list);
  for (const RendererResult& result : v.results) list.push_back(coverage_row(result));
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    for (const RendererResult& result : v.results) {
      list.push_back(row_data(v.shots[s], result.rendering.renderer, result.shots[s]));
    }
  }
  return list;
}

Data claims_rows(const Validation& v) {
  Data list(Data::type::list);
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    if (v.shots[s].stage != Stage::kFinal) continue;
    list.push_back(claims_data(v.shots[s], v.own.renderer, v.own_claims[s]));
    for (const RendererResult& result : v.results) {
      const Judged& judged = result.shots[s];
      if (judged.drawn.status != RenderedShot::Status::kDrawn) continue;
      list.push_back(claims_data(v.shots[s], result.rendering.renderer, judged.claims));
    }
  }
  return list;
}

/// The style class of our picture behind a renderer's.
std::string ours_key(const Validation& v, std::size_t shot, std::size_t renderer) {
  const bool instead = !v.results[renderer].shots[shot].pictures.ours_instead.empty();
  return instead ? fmt::format("{}-{}", v.shots[shot].name, renderer) : v.shots[shot].name;
}

Data own_pictures(const Validation& v) {
  Data list(Data::type::list);
  const auto add = [&](const std::string& key, const std::string& png) {
    Data picture;
    picture.set("key", key);
    picture.set("url", picture_url(png));
    list.push_back(picture);
  };
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    add(v.shots[s].name, v.own_pictures[s]);
    for (std::size_t r = 0; r < v.results.size(); ++r) {
      const std::string& instead = v.results[r].shots[s].pictures.ours_instead;
      if (!instead.empty()) add(ours_key(v, s, r), instead);
    }
  }
  return list;
}

Data card_data(const Validation& v, std::size_t s, std::size_t r) {
  const Judged& judged = v.results[r].shots[s];
  Data card;
  card.set("renderer", v.results[r].rendering.renderer);
  card.set("outcome", std::string(outcome(judged)));
  card.set("why", judged.drawn.why);
  card.set("ours_key", ours_key(v, s, r));
  if (judged.drawn.status == RenderedShot::Status::kDrawn) {
    card.set("url", picture_url(judged.pictures.theirs));
    card.set("difference", picture_url(judged.pictures.difference));
    card.set("max", fmt::format("{:.1e}", judged.comparison.max));
  }
  return card;
}

Data shots_data(const Validation& v) {
  Data finals(Data::type::list), stages(Data::type::list);
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    const bool final = v.shots[s].stage == Stage::kFinal;
    Data shot, cards(Data::type::list);
    for (std::size_t r = 0; r < v.results.size(); ++r) cards.push_back(card_data(v, s, r));
    shot.set("key", v.shots[s].name);
    shot.set("title", final ? v.shots[s].name : v.shots[s].name + " alone");
    shot.set("cards", cards);
    (final ? finals : stages).push_back(shot);
  }
  for (const Data& shot : stages.list_value()) finals.push_back(shot);
  return finals;
}

}  // namespace

std::string report_html(const Validation& v, const ReportHead& head) {
  Data page;
  page.set("scene", head.scene);
  page.set("command", head.command);
  page.set("verdict", std::string(verdict_name(v.verdict)));
  page.set("verdict_class", v.verdict == Verdict::kNothingToCompare
                                ? "skipped"
                                : std::string(verdict_name(v.verdict)));
  page.set("seconds", fmt::format("{:.1f}", v.seconds));
  page.set("width", std::to_string(v.own.shots.front().image.width));
  page.set("height", std::to_string(v.own.shots.front().image.height));
  page.set("columns", std::to_string(v.results.size() + 1));
  page.set("own_version", v.own.version);
  page.set("own_seconds", fmt::format("{:.2f}", v.own.seconds));
  page.set("renderers", renderers_data(v));
  page.set("rows", comparison_rows(v));
  page.set("claims", claims_rows(v));
  page.set("own_pictures", own_pictures(v));
  page.set("shots", shots_data(v));
  return render_page(embedded::report_template(), std::move(page));
}

}  // namespace lumaknot::validate
