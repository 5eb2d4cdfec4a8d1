#include "study/plan/wording.h"

#include <fmt/format.h>

#include <algorithm>

#include "study/measure/statistics.h"

namespace lumaknot::plan {
namespace {

using measure::shown_share;

std::string shift_words(double shift) { return fmt::format("a shift of up to {:g} pixels", shift); }

}  // namespace

Verdict verdict_of(const Plan& plan) {
  if (!plan.met) return Verdict::kNotMet;
  const ToleranceResult& result = plan.chosen.result;
  return result.share(result.met_by_shift()) > kFewShifted ? Verdict::kMetByShift : Verdict::kMet;
}

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kMet:
      return "met";
    case Verdict::kMetByShift:
      return "met by the shift";
    case Verdict::kNotMet:
      break;
  }
  return "can't be met";
}

std::string shares_in_words(const ToleranceResult& result, double shift) {
  const auto share = [&](long long pixels) { return shown_share(result.share(pixels)); };
  std::string text = share(result.met_in_place()) + " of the pixels in place";
  if (result.met_by_shift() > 0) {
    text += fmt::format(", {} only by {}", share(result.met_by_shift()), shift_words(shift));
  }
  if (result.failing > 0) text += fmt::format(", {} not at all", share(result.failing));
  return text;
}

std::string headline(const Plan& plan) {
  const Tolerance& tolerance = plan.tolerance;
  std::string text = fmt::format("{}: {}", verdict_name(verdict_of(plan)),
                                 shares_in_words(plan.chosen.result, tolerance.shift));
  if (tolerance.in_place > 0) {
    text += fmt::format("; {} in place {} demanded", shown_share(tolerance.in_place),
                        plan.met ? "were" : "are");
  }
  return text;
}

std::string own_picture_in_words(const Plan& plan) {
  const ToleranceResult& own = plan.reference;
  const auto share = [&](long long pixels) {
    return shown_share(plan.chosen.result.share(pixels));
  };
  std::string text = fmt::format("the scene's own picture (lumaknot render): {}",
                                 shares_in_words(own, plan.tolerance.shift));
  const std::string lost =
      plan.lost_in_place > 0 ? share(plan.lost_in_place) + " of the pixels" : "no pixel";
  text += fmt::format("; the plan moves {} out of place", lost);
  if (plan.won_in_place > 0) text += fmt::format(", and {} into place", share(plan.won_in_place));
  return text;
}

std::string left_out_in_words(const Plan& plan) {
  constexpr double kNoChange = 1e-9;
  const Pruning& pruning = plan.pruning;
  const std::string allowed =
      fmt::format("{:.2g}, {} of the tolerance, may be spent on what is left out", plan.share,
                  shown_share(plan.share / plan.tolerance.color));
  if (pruning.dropped.empty()) {
    return "Nothing can be left out of the scene's lighting: " + allowed +
           ", and every single part changes some pixel by more";
  }
  const std::string what =
      pruning.dropped.size() == 1
          ? "The one part that is left out changes"
          : fmt::format("The {} parts that are left out together change", pruning.dropped.size());
  if (pruning.change <= kNoChange) return what + " no pixel's colour at all";
  return fmt::format("{} no pixel's colour by more than {:.2g}; {}", what, pruning.change, allowed);
}

std::string shift_warning(const Plan& plan) {
  constexpr double kCloser = 0.05;  // pixels
  const ToleranceResult& result = plan.chosen.result;
  const double share = result.share(result.met_by_shift());
  if (share <= kFewShifted) return "";
  return fmt::format(
      "{} of the pixels meet it by the shift alone: texture or edges change much within {:g} "
      "pixels; try --in-place 99%, {}or more image.samples",
      shown_share(share), plan.tolerance.shift,
      plan.tolerance.shift > kCloser ? fmt::format("--shift {:g} ", kCloser) : "");
}

std::vector<PictureResult> picture_results(const Plan& plan) {
  return {{"as planned", plan.chosen.result},
          {"the scene's own, lumaknot render", plan.reference},
          {"the scene's own, with --fast", plan.fast}};
}

std::string pace_than(double before, double after) {
  const double times = std::max(before, after) / std::min(before, after);
  return fmt::format("{:.{}f} times {} than", times, times < 10 ? 2 : 1,
                     before >= after ? "faster" : "slower");
}

}  // namespace lumaknot::plan
