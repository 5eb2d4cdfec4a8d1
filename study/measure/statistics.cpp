#include "study/measure/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>

namespace lumaknot::measure {

double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

Interval<double> median_interval(std::vector<double> values) {
  constexpr double kTail = 0.025;  // on each side
  const double n = double(values.size());
  std::size_t rank = 0;  // of the bounds, from each end
  double below = 0;      // the chance that fewer than `rank` values are below the median
  for (double k = 0; 2 * k < n; ++k) {
    const double choices = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    below += std::exp(choices - n * std::numbers::ln2);
    if (below > kTail) break;
    ++rank;
  }
  if (rank == 0) return kUnknown;
  std::ranges::sort(values);
  return {values[rank - 1], values[values.size() - rank]};
}

Spread spread_of(std::span<const double> values) {
  const auto [min, max] = std::ranges::minmax(values);
  return {median({values.begin(), values.end()}), min, max};
}

double paired_ratio(std::span<const double> above, std::span<const double> below) {
  assert(above.size() == below.size());
  std::vector<double> ratios;
  ratios.reserve(above.size());
  for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
  return median(std::move(ratios));
}

std::string shown_share(double share) {
  const double percent = 100 * share, rest = std::min(percent, 100 - percent);
  if (!(rest > 0)) return fmt::format("{:.0f} %", percent);
  const int decimals = std::clamp(1 - int(std::floor(std::log10(rest))), 1, 9);
  return fmt::format("{:.{}f} %", percent, decimals);
}

std::string shown_time(double milliseconds) {
  const double rounded = std::stod(fmt::format("{:.2e}", milliseconds));
  const int place = rounded > 0 ? int(std::floor(std::log10(rounded))) : 0;
  return fmt::format("{:.{}f}", milliseconds, std::max(0, 2 - place));
}

}  // namespace lumaknot::measure
