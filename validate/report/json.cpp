#include <cmath>
#include <nlohmann/json.hpp>

#include "validate/renderers/entry.h"
#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

using Json = nlohmann::ordered_json;

Json place_json(const PixelPlace& p) { return Json::array({p.x, p.y}); }

Json classes_json(const Comparison& c) {
  Json classes = Json::object();
  for (std::size_t i = 0; i < c.classes.size(); ++i) {
    classes[std::string(kPixelClassNames[i])] = c.classes[i];
  }
  return classes;
}

Json share_json(const ClassShare& share) {
  return {{"class", allowance_title(share.allowance)},
          {"allow", kAllowanceNames[share.allowance]},
          {"pixels", share.count},
          {"share", share.share()},
          {"of", is_of_silhouette(share.allowance) ? "silhouette" : "covered pixels"},
          {"of_pixels", share.of},
          {"allowed_share", share.cap},
          {"exceeded", share.exceeded}};
}

Json shares_json(const std::vector<ClassShare>& shares) {
  Json list = Json::array();
  for (const ClassShare& share : shares) list.push_back(share_json(share));
  return list;
}

Json comparison_json(const Comparison& c) {
  Json unexplained = Json::array();
  for (const PixelPlace& p : c.unexplained) unexplained.push_back(place_json(p));
  return {{"covered_pixels", c.covered},
          {"coverage_differs", c.coverage_differs},
          {"coverage_unexplained", c.coverage_unexplained},
          {"inside_pixels", c.inside},
          {"mean", c.mean},
          {"rmse", c.rmse},
          {"p99", c.p99},
          {"p99.9", c.p999},
          {"p99.99", c.p9999},
          {"mean_without_classed_outliers", c.mean_unclassed},
          {"p99.9_without_classed_outliers", c.p999_unclassed},
          {"p99.99_without_classed_outliers", c.p9999_unclassed},
          {"max", c.max},
          {"max_at", place_json(c.max_at)},
          {"outliers", c.outliers},
          {"outlier_classes", classes_json(c)},
          {"outliers_not_searched", c.unsearched},
          {"class_shares", shares_json(c.shares)},
          {"unexplained_at", unexplained},
          {"limits_exceeded", c.exceeded}};
}

Json claims_json(const Claims& c) {
  return {{"highlight_pixels", c.highlight_pixels},
          {"highlight_mean_chroma", c.highlight_chroma},
          {"mean_hue_shift_degrees", c.hue_shift_degrees},
          {"share_clipped_at_0", c.clipped_at_zero},
          {"share_clipped_at_1", c.clipped_at_one}};
}

Json shot_json(const Shot& shot, const Judged& judged) {
  Json json{{"shot", shot.name}, {"outcome", outcome(judged)}};
  if (!judged.drawn.why.empty()) json["why"] = judged.drawn.why;
  if (!judged.drawn.note.empty()) json["note"] = judged.drawn.note;
  if (judged.drawn.status != RenderedShot::Status::kDrawn) return json;
  json["comparison"] = comparison_json(judged.comparison);
  if (shot.stage == Stage::kFinal) json["claims"] = claims_json(judged.claims);
  return json;
}

/// A limit as JSON: null if there is none.
Json limit_json(double limit) { return std::isfinite(limit) ? Json(limit) : Json(); }

Json limits_json(const Limits& l) {
  return {{"edge_pixels", l.edge},
          {"mean", limit_json(l.mean)},
          {"p99.9", limit_json(l.p999)},
          {"p99.99", limit_json(l.p9999)},
          {"outlier", limit_json(l.outlier)},
          {"unexplained_share_of_silhouette", l.unexplained},
          {"reason", l.reason}};
}

Json first_difference_json(const RendererResult& result) {
  return result.first_difference.empty() ? Json() : Json(result.first_difference);
}

Json renderer_json(const Validation& validation, const RendererResult& result) {
  const Rendering& r = result.rendering;
  Json shots = Json::array();
  for (std::size_t i = 0; i < result.shots.size(); ++i) {
    shots.push_back(shot_json(validation.shots[i], result.shots[i]));
  }
  return {{"renderer", r.renderer},
          {"version", r.version},
          {"command", r.command},
          {"seconds", r.seconds},
          {"compared_limited_to_0_1", r.limited},
          {"limits", limits_json(renderer_entry(r.renderer).limits)},
          {"coverage",
           {{"outcome", coverage_outcome(result)},
            {"coverage_differs", result.coverage_differs},
            {"unexplained", result.coverage_unexplained},
            {"explained", share_json(result.coverage_share)}}},
          {"outcome", renderer_outcome(result)},
          {"explained", shares_json(result.explained)},
          {"first_difference", first_difference_json(result)},
          {"shots", shots}};
}

Json own_json(const Validation& validation) {
  Json claims = Json::object();
  for (std::size_t i = 0; i < validation.shots.size(); ++i) {
    if (validation.shots[i].stage != Stage::kFinal) continue;
    claims[validation.shots[i].name] = claims_json(validation.own_claims[i]);
  }
  return {{"renderer", validation.own.renderer},
          {"version", validation.own.version},
          {"seconds", validation.own.seconds},
          {"claims", claims}};
}

}  // namespace

std::string report_json(const Validation& validation, const ReportHead& head) {
  double slowest = 0;
  Json renderers = Json::array();
  for (const RendererResult& result : validation.results) {
    slowest = std::max(slowest, result.rendering.seconds);
    renderers.push_back(renderer_json(validation, result));
  }
  const Json json{{"scene", head.scene},
                  {"command", head.command},
                  {"verdict", verdict_name(validation.verdict)},
                  {"seconds", validation.seconds},
                  {"slowest_renderer_seconds", slowest},
                  {"own", own_json(validation)},
                  {"renderers", renderers}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumaknot::validate
