/// Statistics of repeated measurements.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "math/interval.h"

namespace lumaknot::measure {

/// The median and range of measurements.
struct Spread {
  double median = 0, min = 0, max = 0;
};

/// An interval about which nothing is known.
inline constexpr Interval<double> kUnknown{.min = -std::numeric_limits<double>::infinity(),
                                           .max = std::numeric_limits<double>::infinity()};

/// The median of `values`, which must not be empty; of an even number the mean of the middle two.
double median(std::vector<double> values);

/// A confidence interval of at least 95 % for the median of what `values` were drawn from: between
/// two of them (order statistics, for any distribution). kUnknown for fewer than six.
Interval<double> median_interval(std::vector<double> values);

/// Of `values`, which must not be empty.
Spread spread_of(std::span<const double> values);

/// The median of above[i] / below[i]: measurements taken alternately, so that what slows the
/// machine for a while slows both. Equally many of each, at least one.
double paired_ratio(std::span<const double> above, std::span<const double> below);

/// A share in [0, 1] as text, "42.6 %": at least one decimal and two digits of it or of what it
/// lacks; "0 %" and "100 %" are exact.
std::string shown_share(double share);

/// A time as text: three digits, and all before the decimal point.
std::string shown_time(double milliseconds);

}  // namespace lumaknot::measure
