#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

constexpr std::string_view kOutcomeNames[] = {"agreed", "explained", "differed"};
constexpr std::string_view kVerdictNames[] = {"agreed", "explained", "differed",
                                              "nothing to compare"};

/// A share above `share` with one digit, in percent: what a user would write.
std::string round_percent_above(double share) {
  const double percent = 100 * share;
  const double step = std::pow(10, std::floor(std::log10(percent)));
  return fmt::format("{:.6g}", std::min(100.0, (std::floor(percent / step) + 1) * step));
}

}  // namespace

std::string_view outcome(const Judged& shot) {
  if (shot.drawn.status == RenderedShot::Status::kSkipped) return "skipped";
  if (shot.drawn.status == RenderedShot::Status::kFailed) return "failed";
  return kOutcomeNames[std::size_t(shot.comparison.outcome())];
}

std::string_view coverage_outcome(const RendererResult& result) {
  if (!result.drew_any()) return outcome(result.shots.front());
  return kOutcomeNames[std::size_t(result.coverage_outcome())];
}

std::string_view renderer_outcome(const RendererResult& result) {
  if (!result.drew_any()) return outcome(result.shots.front());
  return outcome_name(result.outcome());
}

std::string_view outcome_name(Outcome outcome) { return kOutcomeNames[std::size_t(outcome)]; }

std::string_view verdict_name(Verdict verdict) { return kVerdictNames[std::size_t(verdict)]; }

std::string share_text(const ClassShare& share) {
  return fmt::format("{} {:.3g} % of the {}", allowance_title(share.allowance), 100 * share.share(),
                     is_of_silhouette(share.allowance) ? "silhouette" : "covered pixels");
}

std::string explanation(const std::vector<ClassShare>& shares) {
  std::vector<std::string> classes, flags;
  for (const ClassShare& share : shares) {
    classes.push_back(share_text(share));
    flags.push_back(fmt::format("{}={}%", kAllowanceNames[share.allowance],
                                round_percent_above(share.share())));
  }
  return fmt::format("{}; allow {} with --allow {}", fmt::join(classes, ", "),
                     shares.size() == 1 ? "it" : "them", fmt::join(flags, ","));
}

}  // namespace lumaknot::validate
