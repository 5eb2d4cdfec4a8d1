#include <fmt/format.h>

#include <algorithm>

#include "exporters/image/file.h"
#include "study/measure/method_words.h"
#include "study/measure/statistics.h"
#include "study/plan/wording.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view plan_template();
}  // namespace lumaknot::embedded

namespace lumaknot::plan {
namespace {

using Data = validate::PageData;

std::string number(double value) { return fmt::format("{:.2g}", value); }

std::string number_or_blank(const std::optional<double>& value) {
  return value ? number(*value) : "";
}

Data attempt_row(const Attempt& t) {
  Data row;
  row.set("what", t.what);
  row.set("predicted", number_or_blank(t.bound));
  row.set("measured", number(t.change));
  return row;
}

Data part_row(const ErrorPart& p) {
  Data row;
  row.set("part", p.name);
  row.set("unit", p.unit);
  row.set("predicted", number_or_blank(p.predicted));
  row.set("measured", number(p.measured));
  return row;
}

Data choice_row(const PlanChoice& c) {
  Data row;
  row.set("method", measure::method_words(c.method));
  row.set("place", number(c.predicted.place));
  row.set("shading", number_or_blank(c.predicted.shading));
  row.set("filter", number_or_blank(c.predicted.filter));
  row.set("error", number(c.result.error));
  row.set("class", c.result.met ? "met" : "not");
  row.set("time", c.milliseconds > 0 ? fmt::format("{:.2f}", c.milliseconds) : "");
  return row;
}

/// How one picture meets the tolerance.
Data result_row(const PictureResult& picture) {
  const ToleranceResult& r = picture.result;
  const auto share = [&](long long pixels) {
    return fmt::format("{} ({})", measure::shown_share(r.share(pixels)), pixels);
  };
  Data row;
  row.set("picture", picture.name);
  row.set("in_place", share(r.met_in_place()));
  row.set("by_shift", share(r.met_by_shift()));
  row.set("failing", share(r.failing));
  row.set("largest", fmt::format("{:.3f}", r.in_place));
  row.set("mean", number(r.mean_in_place));
  row.set("error", fmt::format("{:.4f}", r.error));
  return row;
}

const char* verdict_class(Verdict verdict) {
  return verdict == Verdict::kMet ? "met" : verdict == Verdict::kMetByShift ? "by_shift" : "not";
}

Data picture_row(const std::string& caption, const Image& image) {
  Data row;
  row.set("caption", caption);
  row.set("alt", caption);
  row.set("url", validate::picture_url(display_png(image)));
  return row;
}

/// Those that met the tolerance first, by time; then the others by error.
std::vector<PlanChoice> sorted(std::vector<PlanChoice> candidates) {
  const auto key = [](const PlanChoice& c) {
    const bool timed = c.result.met && c.milliseconds > 0;
    return std::tuple(!c.result.met, !timed, timed ? c.milliseconds : c.result.error);
  };
  std::ranges::stable_sort(candidates, {}, key);
  return candidates;
}

}  // namespace

std::string plan_html(const Plan& plan, const std::string& scene, const std::string& command) {
  Data page;
  const double after = plan.chosen.milliseconds;
  page.set("scene", scene);
  page.set("command", command);
  page.set("headline", headline(plan));
  page.set("verdict_class", verdict_class(verdict_of(plan)));
  page.set("own", own_picture_in_words(plan));
  page.set("chosen", plan.met ? "Planned" : "Closest");
  page.set("method", measure::method_words(plan.chosen.method));
  page.set("color", fmt::format("{:.4g}", plan.tolerance.color));
  page.set("shift", fmt::format("{:.4g}", plan.tolerance.shift));
  page.set("truth", plan.area ? "the mean over each pixel" : "the colour at each pixel's centre");
  page.set("results", validate::page_list(picture_results(plan), result_row));
  page.set("hidden", std::to_string(plan.chosen.result.hidden));
  page.set("has_shift", plan.tolerance.shift > 0);
  page.set("warning", shift_warning(plan));
  page.set("has_warning", !shift_warning(plan).empty());
  page.set("pixels", std::to_string(plan.chosen.result.covered));
  page.set("left_out", left_out_in_words(plan));
  page.set("dropped", validate::page_list(plan.pruning.dropped, attempt_row));
  page.set("has_dropped", !plan.pruning.dropped.empty());
  page.set("kept", validate::page_list(plan.pruning.kept, attempt_row));
  page.set("parts", validate::page_list(plan.parts, part_row));
  page.set("blamed", validate::page_list(plan.blamed, [](const Attribution& b) {
             Data row;
             row.set("part", b.part);
             row.set("pixels", std::to_string(b.pixels));
             return row;
           }));
  page.set("has_blamed", !plan.blamed.empty());
  page.set("reference", fmt::format("{:.1f}", plan.reference_milliseconds));
  page.set("fast", fmt::format("{:.2f}", plan.fast_milliseconds));
  page.set("after", fmt::format("{:.2f}", after));
  page.set("than_reference", pace_than(plan.reference_milliseconds, after));
  page.set("than_fast", pace_than(plan.fast_milliseconds, after));
  page.set("has_best", plan.best_of_all.has_value());
  if (plan.best_of_all) {
    page.set("best", measure::method_words(plan.best_of_all->method));
    page.set("to_best", fmt::format("{:.2f}", plan.time_to_best));
  }
  page.set("considered", std::to_string(plan.considered));
  page.set("measured", std::to_string(plan.candidates.size()));
  page.set("legend", measure::method_legend_rows());
  page.set("choices", validate::page_list(sorted(plan.candidates), choice_row));
  Data pictures(Data::type::list);
  pictures.push_back(picture_row("before: the reference", plan.before));
  pictures.push_back(picture_row("after: as planned", plan.after));
  pictures.push_back(
      picture_row("error in place: white is the tolerance, red beyond it", plan.in_place));
  if (plan.tolerance.shift > 0) {
    pictures.push_back(
        picture_row("error after the shift: white is the tolerance, red beyond it", plan.errors));
  }
  page.set("pictures", pictures);
  return validate::render_page(embedded::plan_template(), std::move(page));
}

}  // namespace lumaknot::plan
