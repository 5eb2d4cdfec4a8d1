/// What repeated measurements have in common.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lumaknot {

/// Where measurements lie.
struct Spread {
  double median = 0, least = 0, most = 0;
};

/// From where to where something lies; everywhere unless it is known.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// The middle of `values`, which must not be empty; of an even number the mean of the middle two.
double median(std::vector<double> values);

/// The least of `values`, which must not be empty, that `share` of them don't exceed; share in
/// (0, 1].
double quantile(std::vector<double> values, double share);

/// Where the median of what `values` were drawn from lies, at 95 % or more: between two of them
/// (order statistics, whatever the distribution). Everywhere for fewer than six.
Interval median_interval(std::vector<double> values);

/// Of `values`, which must not be empty.
Spread spread_of(std::span<const double> values);

/// The median of above[i] / below[i]: measurements taken in turns, so that what slows the machine
/// for a while slows both. As many of each, and not none.
double paired_ratio(std::span<const double> above, std::span<const double> below);

/// A time for a reader: three digits, and all before the decimal point.
std::string shown_time(double milliseconds);

}  // namespace lumaknot
