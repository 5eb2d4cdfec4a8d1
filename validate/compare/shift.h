/// Whether a picture lies aside as a whole.
#pragma once

#include <vector>

#include "validate/compare/pixel_error.h"

namespace lumaknot::validate {

/// By how many pixels another picture lies to the right of ours and below it.
struct Shift {
  double x = 0, y = 0;
  double deviation = 0;  ///< standard deviation of either
  double explained = 0;  ///< share of the squared errors that is gone without the shift

  double size() const;
};

/// The shift that fits the errors best, by our colours' slopes; each pixel counts as much as its
/// limit is small, and one beyond its limit as little as it is beyond. Without slopes: none, of
/// infinite deviation.
Shift fitted_shift(const std::vector<PixelError>& pixels);

}  // namespace lumaknot::validate
