#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "study/planning/plan.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json tried_json(const std::vector<Tried>& all) {
  Json list = Json::array();
  for (const Tried& t : all) {
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

Json choice_json(const PlanChoice& c) {
  Json json{{"method", method_name(c.method)},
            {"predicted", predicted_json(c.predicted)},
            {"measured",
             {{"error", c.judgement.error},
              {"in_place", c.judgement.in_place},
              {"pixels", c.judgement.covered},
              {"beyond_in_place", c.judgement.shifted},
              {"hidden", c.judgement.hidden},
              {"failing", c.judgement.failing}}},
            {"met", c.judgement.met}};
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

std::string number_or_none(const std::optional<double>& value) {
  return value ? fmt::format("{:.2g}", *value) : "-";
}

std::string dropped_text(const Plan& plan) {
  if (plan.dropping.dropped.empty()) return "  nothing can be left out\n";
  std::string text =
      fmt::format("  {:<40} {:>10} {:>10}\n", "left out or simpler", "predicted", "measured");
  for (const Tried& t : plan.dropping.dropped) {
    text += fmt::format("  {:<40} {:>10} {:>10.2g}\n", t.what, number_or_none(t.bound), t.change);
  }
  return text + fmt::format("  {:<40} {:>10.2g} {:>10.2g}\n", "all of it, of a share of",
                            plan.share, plan.dropping.change);
}

std::string parts_text(const Plan& plan) {
  std::string text;
  for (const ErrorPart& p : plan.parts) {
    text += fmt::format("  {:<40} {:>10} {:>10.2g}\n", p.name + ", " + p.unit,
                        number_or_none(p.predicted), p.measured);
  }
  const Judgement& j = plan.chosen.judgement;
  return text + fmt::format("  {:<40} {:>10.2g} {:>10.2g}\n",
                            fmt::format("whole, of {} pixels, of a tolerance of", j.covered),
                            plan.tolerance.color, j.error);
}

std::string blame_text(const Plan& plan) {
  std::string text = "can't be met:";
  for (const Blame& b : plan.blamed) {
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

std::string plan_json(const Plan& plan) {
  Json json{
      {"met", plan.met},
      {"tolerance", {{"color", plan.tolerance.color}, {"shift_pixels", plan.tolerance.shift}}},
      {"truth", plan.area ? "the mean over each pixel of the exact surface"
                          : "each pixel's centre on the exact surface"},
      {"dropped", tried_json(plan.dropping.dropped)},
      {"dropped_together", {{"share", plan.share}, {"measured", plan.dropping.change}}},
      {"kept", tried_json(plan.dropping.kept)},
      {"chosen", choice_json(plan.chosen)},
      {"parts", parts_json(plan.parts)},
      {"milliseconds", times_json(plan)}};
  for (const Blame& b : plan.blamed) {
    json["blame"].push_back({{"part", b.part}, {"pixels", b.pixels}});
  }
  if (plan.best_of_all) {
    json["exhaustive"] = {{"best", choice_json(*plan.best_of_all)},
                          {"time_to_best", plan.time_to_best}};
  }
  json["render_arguments"] = render_arguments(plan.chosen.method);
  json["considered"] = plan.considered;
  for (const PlanChoice& c : plan.choices) json["choices"].push_back(choice_json(c));
  return json.dump(2) + "\n";
}

std::string plan_text(const Plan& plan) {
  const double after = plan.chosen.milliseconds;
  std::string text = plan.met ? "met: " : blame_text(plan);
  text += method_name(plan.chosen.method) + "\n" + dropped_text(plan) + parts_text(plan);
  text += fmt::format(
      "  {:.2f} ms a frame on one thread; before {:.1f} ms by the reference ({:.1f} times), {:.2f} "
      "ms "
      "by --fast ({:.2f} times)",
      after, plan.reference_milliseconds, plan.reference_milliseconds / after,
      plan.fast_milliseconds, plan.fast_milliseconds / after);
  if (plan.best_of_all) {
    text += fmt::format("\n  {:.2f} times the time of the best of all {} choices, {}",
                        plan.time_to_best, plan.considered, method_name(plan.best_of_all->method));
  }
  return text;
}

}  // namespace lumaknot
