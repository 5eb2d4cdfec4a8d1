#include "study/paper/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lumaknot::paper {
namespace {

/// "61,440".
std::string grouped(long long value) {
  const std::string digits = std::to_string(std::abs(value));
  std::string text = value < 0 ? "-" : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? figure_text(value) : figure_text(value) + " " + unit;
}

}  // namespace

bool Measure::meets() const {
  return std::isfinite(value) && !(min && value < *min) && !(max && value > *max);
}

Measure note(std::string what, double value, std::string unit) {
  return {std::move(what), value, std::move(unit), {}, {}};
}

Measure at_most(std::string what, double value, double max, std::string unit) {
  return {std::move(what), value, std::move(unit), {}, max};
}

Measure at_least(std::string what, double value, double min, std::string unit) {
  return {std::move(what), value, std::move(unit), min, {}};
}

Measure within(std::string what, double value, double min, double max, std::string unit) {
  return {std::move(what), value, std::move(unit), min, max};
}

Ruling ruling_of(const PaperClaim& claim) {
  const auto bound = std::ranges::count_if(claim.measures, &Measure::is_bound);
  if (bound == 0) return Ruling::kNotMeasurable;
  const auto met = std::ranges::count_if(
      claim.measures, [](const Measure& m) { return m.is_bound() && m.meets(); });
  if (met == bound) return Ruling::kHolds;
  return met > 0 ? Ruling::kHoldsInPart : Ruling::kDoesNotHold;
}

std::string_view ruling_name(Ruling ruling) {
  constexpr std::string_view kNames[] = {"holds", "holds in part", "does not hold",
                                         "not measurable here"};
  return kNames[std::size_t(ruling)];
}

std::string figure_text(double value) {
  if (!std::isfinite(value)) return "not a number";
  constexpr double kWhole = 1e9;
  if (std::abs(value) < kWhole && value == std::round(value)) return grouped(std::llround(value));
  return std::abs(value) >= 1000 && std::abs(value) < kWhole ? grouped(std::llround(value))
                                                             : fmt::format("{:.3g}", value);
}

std::string value_text(const Measure& measure) { return with_unit(measure.value, measure.unit); }

std::string bound_text(const Measure& m) {
  if (m.min && m.max && *m.min == *m.max) return with_unit(*m.min, m.unit);
  if (m.min && m.max) {
    return fmt::format("{} to {}", figure_text(*m.min), with_unit(*m.max, m.unit));
  }
  if (m.min) return "at least " + with_unit(*m.min, m.unit);
  return m.max ? "at most " + with_unit(*m.max, m.unit) : "";
}

long long count_of(const std::vector<PaperClaim>& claims, Ruling ruling) {
  return std::ranges::count(claims, ruling, ruling_of);
}

}  // namespace lumaknot::paper
