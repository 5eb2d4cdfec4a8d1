/// Limits of a picture's errors that a user states.
#pragma once

#include <optional>

namespace lumaknot::validate {

/// Errors are of colours: the largest difference of a pixel's three channels. The mean and the
/// quantile are of pixels inside that are in no class.
struct Limits {
  std::optional<double> max = {};  ///< a larger error needs a class; empty: each pixel's own limit
  std::optional<double> mean = {}, p999 = {};  ///< empty: none
};

}  // namespace lumaknot::validate
