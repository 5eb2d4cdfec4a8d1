/// Intervals of numbers.
#pragma once

#include <limits>

namespace lumaknot {

/// The finite numbers from `min` to `max`, excluding the ends where `open_min`, `open_max` are set.
template <class T>
struct Interval {
  T min = std::numeric_limits<T>::lowest();
  T max = std::numeric_limits<T>::max();
  bool open_min = false, open_max = false;
};

inline constexpr Interval<double> kPositive{.min = 0, .open_min = true};
inline constexpr Interval<double> kNotNegative{.min = 0};

}  // namespace lumaknot
