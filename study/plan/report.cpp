#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "study/plan/outcome.h"

namespace lumaknot::plan {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json attempts_json(const std::vector<Attempt>& all) {
  Json list = Json::array();
  for (const Attempt& t : all) {
    list.push_back({{"what", t.what}, {"predicted", or_null(t.bound)}, {"measured", t.change}});
  }
  return list;
}

Json predicted_json(const PredictedError& p) {
  return {{"place_pixels", p.place},
          {"sampling_pixels", p.sampling},
          {"shading", or_null(p.shading)},
          {"filter", or_null(p.filter)},
          {"precision", p.precision}};
}

Json measured_json(const ToleranceResult& j) {
  return {{"error", j.error},    {"in_place", j.in_place},       {"mean_in_place", j.mean_in_place},
          {"pixels", j.covered}, {"beyond_in_place", j.shifted}, {"hidden", j.hidden},
          {"failing", j.failing}};
}

Json choice_json(const PlanChoice& c) {
  Json json{{"method", measure::method_name(c.method)},
            {"predicted", predicted_json(c.predicted)},
            {"measured", measured_json(c.result)},
            {"met", c.result.met}};
  if (c.milliseconds > 0) json["milliseconds"] = c.milliseconds;
  return json;
}

Json parts_json(const std::vector<ErrorPart>& parts) {
  Json list = Json::array();
  for (const ErrorPart& p : parts) {
    list.push_back({{"part", p.name},
                    {"unit", p.unit},
                    {"predicted", or_null(p.predicted)},
                    {"measured", p.measured}});
  }
  return list;
}

Json times_json(const Plan& plan) {
  const double after = plan.chosen.milliseconds;
  return {{"before_reference", plan.reference_milliseconds},
          {"before_fast", plan.fast_milliseconds},
          {"after", after},
          {"times_faster_than_reference", plan.reference_milliseconds / after},
          {"times_faster_than_fast", plan.fast_milliseconds / after}};
}

std::string number_or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.2g}", *value) : "-";
}

std::string dropped_text(const Plan& plan) {
  if (plan.pruning.dropped.empty()) return "  nothing can be left out\n";
  std::string text =
      fmt::format("  {:<40} {:>10} {:>10}\n", "left out or simpler", "predicted", "measured");
  for (const Attempt& t : plan.pruning.dropped) {
    text += fmt::format("  {:<40} {:>10} {:>10.2g}\n", t.what, number_or_dash(t.bound), t.change);
  }
  return text + fmt::format("  {:<40} {:>10.2g} {:>10.2g}\n", "all of it, of a share of",
                            plan.share, plan.pruning.change);
}

/// What was needed of the colour and of the place.
std::string result_text(const Plan& plan) {
  const ToleranceResult& j = plan.chosen.result;
  std::string text = fmt::format(
      "  in place {} of {} pixels ({:.3g} %) are beyond {:.2g}: by {:.2g} at most, the mean of all "
      "is {:.2g}\n",
      j.shifted, j.covered, 100.0 * double(j.shifted) / double(j.covered), plan.tolerance.color,
      j.in_place, j.mean_in_place);
  if (plan.tolerance.shift > 0) {
    text += fmt::format(
        "  within {:g} pixels {} stay beyond, {:.2g} off at most; {} count for what is hidden by "
        "less\n",
        plan.tolerance.shift, j.failing, j.error, j.hidden);
  }
  const std::string warning = shift_warning(plan);
  return warning.empty() ? text : text + "  warning: " + warning + "\n";
}

std::string times_text(const Plan& plan) {
  const double after = plan.chosen.milliseconds;
  return fmt::format(
      "  {:.2f} ms a frame on one thread, {} the reference ({:.1f} ms), {} --fast ({:.2f} ms), "
      "whose "
      "picture of the scene as it was {} the tolerance",
      after, pace_than(plan.reference_milliseconds, after), plan.reference_milliseconds,
      pace_than(plan.fast_milliseconds, after), plan.fast_milliseconds,
      plan.fast.met ? "meets" : "does not meet");
}

std::string parts_text(const Plan& plan) {
  std::string text;
  for (const ErrorPart& p : plan.parts) {
    text += fmt::format("  {:<40} {:>10} {:>10.2g}\n", p.name + ", " + p.unit,
                        number_or_dash(p.predicted), p.measured);
  }
  return text;
}

std::string blame_text(const Plan& plan) {
  std::string text = "can't be met:";
  for (const Attribution& b : plan.blamed) {
    text +=
        fmt::format("{} {} pixels by {}", &b == plan.blamed.data() ? "" : ",", b.pixels, b.part);
  }
  if (plan.tolerance.shift == 0) {
    text +=
        "\nno edge can be met by colour alone: corners are snapped to parts of a pixel; allow a "
        "--shift";
  }
  return text + "\nclosest: ";
}

}  // namespace

std::string shift_warning(const Plan& plan) {
  constexpr double kFew = 0.1;
  constexpr double kCloser = 0.05;  // pixels
  if (plan.shifted_share() <= kFew) return "";
  return fmt::format(
      "{:.3g} % of the pixels meet it by the shift alone: texture or edges change much within {:g} "
      "pixels; try {}more image.samples",
      100 * plan.shifted_share(), plan.tolerance.shift,
      plan.tolerance.shift > kCloser ? fmt::format("--shift {:g} or ", kCloser) : "");
}

std::string pace_than(double before, double after) {
  const double times = std::max(before, after) / std::min(before, after);
  return fmt::format("{:.{}f} times {} than", times, times < 10 ? 2 : 1,
                     before >= after ? "faster" : "slower");
}

std::string plan_json(const Plan& plan) {
  Json json{
      {"met", plan.met},
      {"tolerance", {{"color", plan.tolerance.color}, {"shift_pixels", plan.tolerance.shift}}},
      {"truth", plan.area ? "the mean over each pixel of the exact surface"
                          : "each pixel's centre on the exact surface"},
      {"dropped", attempts_json(plan.pruning.dropped)},
      {"dropped_together", {{"share", plan.share}, {"measured", plan.pruning.change}}},
      {"kept", attempts_json(plan.pruning.kept)},
      {"chosen", choice_json(plan.chosen)},
      {"by_shift_alone", {{"pixels", plan.shifted()}, {"share", plan.shifted_share()}}},
      {"parts", parts_json(plan.parts)},
      {"milliseconds", times_json(plan)},
      {"before_fast", {{"met", plan.fast.met}, {"measured", measured_json(plan.fast)}}}};
  if (const std::string warning = shift_warning(plan); !warning.empty()) json["warning"] = warning;
  for (const Attribution& b : plan.blamed) {
    json["blame"].push_back({{"part", b.part}, {"pixels", b.pixels}});
  }
  if (plan.best_of_all) {
    json["exhaustive"] = {{"best", choice_json(*plan.best_of_all)},
                          {"time_to_best", plan.time_to_best}};
  }
  json["render_arguments"] = render_arguments(plan.chosen.method);
  json["considered"] = plan.considered;
  for (const PlanChoice& c : plan.candidates) json["choices"].push_back(choice_json(c));
  return json.dump(2) + "\n";
}

std::string plan_text(const Plan& plan) {
  std::string text = plan.met ? "met: " : blame_text(plan);
  text += measure::method_name(plan.chosen.method) + "\n" + result_text(plan) + dropped_text(plan) +
          parts_text(plan) + times_text(plan);
  if (plan.best_of_all) {
    text += fmt::format("\n  {:.2f} times the time of the best of all {} choices, {}",
                        plan.time_to_best, plan.considered,
                        measure::method_name(plan.best_of_all->method));
  }
  return text;
}

}  // namespace lumaknot::plan
