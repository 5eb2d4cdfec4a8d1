#include "study/paper/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lumaknot {
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
  return std::isfinite(value) && !(least && value < *least) && !(most && value > *most);
}

Measure note(std::string what, double value, std::string unit) {
  return {std::move(what), value, std::move(unit), {}, {}};
}

Measure at_most(std::string what, double value, double most, std::string unit) {
  return {std::move(what), value, std::move(unit), {}, most};
}

Measure at_least(std::string what, double value, double least, std::string unit) {
  return {std::move(what), value, std::move(unit), least, {}};
}

Measure within(std::string what, double value, double least, double most, std::string unit) {
  return {std::move(what), value, std::move(unit), least, most};
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
  if (m.least && m.most && *m.least == *m.most) return with_unit(*m.least, m.unit);
  if (m.least && m.most) {
    return fmt::format("{} to {}", figure_text(*m.least), with_unit(*m.most, m.unit));
  }
  if (m.least) return "at least " + with_unit(*m.least, m.unit);
  return m.most ? "at most " + with_unit(*m.most, m.unit) : "";
}

long long count_of(const std::vector<PaperClaim>& claims, Ruling ruling) {
  return std::ranges::count(claims, ruling, ruling_of);
}

}  // namespace lumaknot
