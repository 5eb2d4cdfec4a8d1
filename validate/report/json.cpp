#include <cmath>
#include <nlohmann/json.hpp>

#include "diagnosis/report.h"
#include "validate/noise.h"
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

Json use_json(const LimitUse& use) {
  Json parts = Json::object();
  for (std::size_t i = 0; i < use.limit.of.size(); ++i) {
    parts[std::string(kLimitPartNames[i])] = use.limit.of[i];
  }
  return {{"error_over_limit_p50", use.p50},    {"error_over_limit_p99", use.p99},
          {"error_over_limit_p99.9", use.p999}, {"error_over_limit_max", use.max},
          {"worst_at", place_json(use.worst)},  {"error", use.error},
          {"limit", use.limit.sum()},           {"limit_parts", parts}};
}

Json shift_json(const Comparison& c) {
  return {
      {"x", c.shift.x},
      {"y", c.shift.y},
      {"standard_deviation", std::isfinite(c.shift.deviation) ? Json(c.shift.deviation) : Json()},
      {"explains_share", c.shift.explained},
      {"limit", c.shift_limit}};
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
          {"limits", use_json(c.use)},
          {"shift_pixels", shift_json(c)},
          {"outliers", c.outliers},
          {"outlier_classes", classes_json(c)},
          {"outliers_not_searched", c.unsearched},
          {"class_shares", shares_json(c.shares)},
          {"unexplained_at", unexplained},
          {"limits_exceeded", c.exceeded}};
}

Json finding_json(const NoiseFinding& f) {
  return {{"at", place_json(f.place)},
          {"channel", kChannelNames[f.channel]},
          {"bias", f.bias},
          {"distance", f.distance},
          {"admitted", f.admitted},
          {"standard_deviation", f.deviation}};
}

Json noise_json(const NoiseTest& test) {
  Json scales = Json::array();
  for (const NoiseScale& scale : test.scales) {
    scales.push_back({{"block_pixels", scale.block},
                      {"tests", scale.tests},
                      {"exceeded", scale.exceeded},
                      {"exceeded_in_coverage", scale.coverage_exceeded},
                      {"noise", scale.noise},
                      {"bias_seen", scale.seen},
                      {"worst", finding_json(scale.worst)}});
  }
  return {{"family_error", test.family_error}, {"scales", scales}};
}

/// Null if it was not denoised.
Json denoised_json(const std::optional<DenoisedErrors>& errors) {
  if (!errors) return {};
  return {{"noisy_rmse", errors->noisy},
          {"rmse", errors->denoised},
          {"shared_rmse", errors->bias},
          {"bias_of_whole_picture", errors->whole}};
}

/// Null without random samples.
Json sampling_json(const Validation& validation) {
  if (!validation.sampling) return {};
  const Sampling& s = *validation.sampling;
  return {{"samples", s.samples},
          {"seeds", Json::array({s.seed, s.seed + 1})},
          {"family_error", kFamilyError}};
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
  if (!judged.noise.scales.empty()) {
    json["noise"] = noise_json(judged.noise);
    json["denoised"] = denoised_json(judged.denoised);
  } else if (shot.stage == Stage::kFinal) {
    json["claims"] = claims_json(judged.claims);
  }
  return json;
}

Json promise_json(const Promise& p) {
  return {{"grid_bits", p.grid_bits},
          {"interpolates_snapped_vertices", p.snaps_shade},
          {"sample_roundings", p.sample_roundings},
          {"position_roundings", p.position_roundings},
          {"normal_roundings", p.normal_roundings},
          {"uv_roundings", p.uv_roundings},
          {"formula_roundings", p.formula_roundings},
          {"power_error", p.power_error},
          {"texture_step", p.texture_step},
          {"texel_weight", p.texel_weight},
          {"output_step", p.output_step},
          {"output_step_relative", p.output_relative},
          {"unexplained_share_of_silhouette", p.unexplained},
          {"reason", p.reason}};
}

/// The user's limits; empty without any.
Json limits_json(const Limits& l) {
  Json json = Json::object();
  if (l.max) json["max"] = *l.max;
  if (l.p999) json["p99.9"] = *l.p999;
  if (l.mean) json["mean"] = *l.mean;
  return json;
}

Json first_difference_json(const RendererResult& result) {
  return result.first_difference.empty() ? Json() : Json(result.first_difference);
}

/// What was found out about its difference: null if it agrees.
Json cause_json(const RendererResult& result) {
  if (!result.found_cause) return {};
  Json json = Json::parse(diagnosis::report_json(result.found_cause->diagnosis));
  json["sentence"] = result.cause;
  json["shot"] = result.found_cause->shot;
  return json;
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
          {"promise", promise_json(result.promise)},
          {"limits", limits_json(result.limits)},
          {"coverage",
           {{"outcome", coverage_outcome(result)},
            {"coverage_differs", result.coverage_differs},
            {"unexplained", result.coverage_unexplained},
            {"explained", share_json(result.coverage_share)}}},
          {"outcome", renderer_outcome(result)},
          {"explained", shares_json(result.explained)},
          {"first_difference", first_difference_json(result)},
          {"cause", cause_json(result)},
          {"shots", shots}};
}

Json own_json(const Validation& validation) {
  Json claims = Json::object();
  for (std::size_t i = 0; i < validation.shots.size(); ++i) {
    if (validation.shots[i].stage != Stage::kFinal || validation.sampling) continue;
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
                  {"noise", sampling_json(validation)},
                  {"own", own_json(validation)},
                  {"renderers", renderers}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumaknot::validate
