#include "study/bench/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "study/paper/reproduction.h"

namespace lumaknot::paper {
namespace {

using Json = nlohmann::ordered_json;

Json measure_json(const Measure& m) {
  Json json{{"what", m.what}, {"value", m.value}, {"unit", m.unit}};
  if (m.min) json["least"] = *m.min;
  if (m.max) json["most"] = *m.max;
  if (m.is_bound()) json["meets"] = m.meets();
  return json;
}

Json claim_json(const PaperClaim& c) {
  Json json{{"name", c.name}, {"section", kPaperSections[c.section]},
            {"says", c.says}, {"verdict", ruling_name(ruling_of(c))},
            {"how", c.how},   {"measures", Json::array()}};
  for (const Measure& m : c.measures) json["measures"].push_back(measure_json(m));
  if (!c.beyond.empty()) json["beyond"] = c.beyond;
  return json;
}

Json image_json(const FigureImage& image) {
  Json json{{"renderer", image.renderer}};
  if (!image.file.empty()) json["file"] = image.file;
  if (image.outcome.empty()) return json;
  json["outcome"] = image.outcome;
  if (image.file.empty()) {
    json["why"] = image.why;
  } else {
    json["mean"] = image.mean;
    json["agree"] = image.agree;
  }
  if (!image.note.empty()) json["note"] = image.note;
  return json;
}

Json figure_json(const std::vector<FigurePicture>& pictures) {
  Json json = Json::array();
  for (const FigurePicture& p : pictures) {
    Json images = Json::array();
    for (const FigureImage& image : p.images) images.push_back(image_json(image));
    json.push_back({{"name", p.name}, {"caption", p.caption}, {"images", images}});
  }
  return json;
}

Json renderer_json(const FigureRenderer& r) {
  if (!r.missing.empty()) return {{"name", r.name}, {"missing", r.missing}};
  return {{"name", r.name}, {"version", r.version}, {"seconds", r.seconds}};
}

}  // namespace

std::string paper_json(const PaperResult& result) {
  Json json{{"side", result.side},
            {"renderers", Json::array()},
            {"figure1", figure_json(result.figures.figure1)},
            {"figure2", figure_json(result.figures.figure2)},
            {"claims", Json::array()}};
  for (const FigureRenderer& r : result.figures.renderers) {
    json["renderers"].push_back(renderer_json(r));
  }
  for (const PaperClaim& claim : result.claims) json["claims"].push_back(claim_json(claim));
  json["table2"] = Json::parse(bench::rates_json(result.rates));
  return json.dump(2) + "\n";
}

std::string paper_text(const PaperResult& result) {
  std::string text;
  for (const PaperClaim& claim : result.claims) {
    text += fmt::format("{:<20}  {:<20}", claim.name, ruling_name(ruling_of(claim)));
    if (!claim.measures.empty()) {
      const Measure& first = claim.measures.front();
      text += fmt::format("  {}: {}", first.what, value_text(first));
      const std::string bound = bound_text(first);
      if (!bound.empty()) text += fmt::format(" ({})", bound);
    }
    text += "\n";
  }
  for (const FigureRenderer& r : result.figures.renderers) {
    if (!r.missing.empty()) text += fmt::format("{} is missing: {}\n", r.name, r.missing);
  }
  return text;
}

}  // namespace lumaknot::paper
