#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "study/measure/method_words.h"
#include "study/measure/statistics.h"
#include "study/plan/wording.h"

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
            {"words", measure::method_words(c.method)},
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
  std::string text;
  if (!plan.pruning.dropped.empty()) {
    text = fmt::format("  {:<40} {:>10} {:>10}\n", "left out or simpler", "predicted", "measured");
  }
  for (const Attempt& t : plan.pruning.dropped) {
    text += fmt::format("  {:<40} {:>10} {:>10.2g}\n", t.what, number_or_dash(t.bound), t.change);
  }
  return text + "  " + left_out_in_words(plan) + "\n";
}

/// What was needed of the colour and of the place.
std::string result_text(const Plan& plan) {
  std::string text =
      fmt::format("  {:<34} {:>11} {:>11} {:>11} {:>9} {:>9}\n", "errors in place and by the shift",
                  "in place", "by shift", "not at all", "largest", "mean");
  for (const PictureResult& picture : picture_results(plan)) {
    const ToleranceResult& r = picture.result;
    const auto share = [&r](long long pixels) { return measure::shown_share(r.share(pixels)); };
    text += fmt::format("  {:<34} {:>11} {:>11} {:>11} {:>9.2g} {:>9.2g}\n", picture.name,
                        share(r.met_in_place()), share(r.met_by_shift()), share(r.failing),
                        r.in_place, r.mean_in_place);
  }
  const ToleranceResult& r = plan.chosen.result;
  text += fmt::format(
      "  of {} pixels; within is {:.2g} of the largest channel, errors are those in place; {} "
      "pixels "
      "count for what is hidden by less than the shift\n",
      r.covered, plan.tolerance.color, r.hidden);
  const std::string warning = shift_warning(plan);
  return warning.empty() ? text : text + "  warning: " + warning + "\n";
}

std::string times_text(const Plan& plan) {
  const double after = plan.chosen.milliseconds;
  return fmt::format(
      "  {:.2f} ms a frame on one thread, {} the reference ({:.1f} ms), {} --fast ({:.2f} ms)",
      after, pace_than(plan.reference_milliseconds, after), plan.reference_milliseconds,
      pace_than(plan.fast_milliseconds, after), plan.fast_milliseconds);
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
  std::string text = "\n  beyond it:";
  for (const Attribution& b : plan.blamed) {
    text += fmt::format("{} {} pixel{} by {}", &b == plan.blamed.data() ? "" : ",", b.pixels,
                        b.pixels == 1 ? "" : "s", b.part);
  }
  if (plan.tolerance.shift == 0) {
    text +=
        "\n  no edge can be met by colour alone: corners are snapped to parts of a pixel; allow a "
        "--shift";
  }
  return text + "\n  closest:";
}

Json own_json(const ToleranceResult& result) {
  return {{"met", result.met}, {"measured", measured_json(result)}};
}

Json in_place_json(const Plan& plan) {
  const ToleranceResult& result = plan.chosen.result;
  return {{"pixels", result.met_in_place()},     {"share", result.share(result.met_in_place())},
          {"demanded", plan.tolerance.in_place}, {"lacking_pixels", result.lacking},
          {"lost_pixels", plan.lost_in_place},   {"won_pixels", plan.won_in_place}};
}

Json by_shift_json(const ToleranceResult& result) {
  return {{"pixels", result.met_by_shift()}, {"share", result.share(result.met_by_shift())}};
}

}  // namespace

std::string plan_json(const Plan& plan) {
  Json json{
      {"met", plan.met},
      {"headline", headline(plan)},
      {"own_picture", own_picture_in_words(plan)},
      {"tolerance", {{"color", plan.tolerance.color}, {"shift_pixels", plan.tolerance.shift}}},
      {"truth", plan.area ? "the mean over each pixel of the exact surface"
                          : "each pixel's centre on the exact surface"},
      {"dropped", attempts_json(plan.pruning.dropped)},
      {"dropped_together", {{"share", plan.share}, {"measured", plan.pruning.change}}},
      {"kept", attempts_json(plan.pruning.kept)},
      {"chosen", choice_json(plan.chosen)},
      {"in_place", in_place_json(plan)},
      {"by_shift_alone", by_shift_json(plan.chosen.result)},
      {"parts", parts_json(plan.parts)},
      {"milliseconds", times_json(plan)},
      {"before_reference", own_json(plan.reference)},
      {"before_fast", own_json(plan.fast)}};
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
  std::string text = fmt::format("{}\n  {}", headline(plan), own_picture_in_words(plan));
  text += plan.met ? "\n  planned:" : blame_text(plan);
  text += fmt::format(" {}\n", measure::method_words(plan.chosen.method));
  text += result_text(plan) + dropped_text(plan) + parts_text(plan) + times_text(plan);
  if (plan.best_of_all) {
    text += fmt::format("\n  {:.2f} times the time of the best of all {} choices, {}",
                        plan.time_to_best, plan.considered,
                        measure::method_words(plan.best_of_all->method));
  }
  return text;
}

}  // namespace lumaknot::plan
