/// One pixel of a comparison.
#pragma once

#include <optional>

#include "validate/compare/explain.h"
#include "validate/compare/sensitivity.h"

namespace lumaknot::validate {

/// A pixel that is covered in both images.
struct PixelError {
  PixelPlace place;
  double error = 0;                 ///< the largest difference of a channel
  double limit = 0;                 ///< of that
  double signed_error = 0;          ///< theirs less ours, in the channel that changes most
  double slope_x = 0, slope_y = 0;  ///< of ours, per pixel, in that channel
  bool inside = false;              ///< not at a silhouette
  std::optional<PixelClass> why;    ///< if the error is beyond the limit

  bool classed() const { return why && *why != PixelClass::kUnexplained; }
  double ratio() const { return error / limit; }
};

}  // namespace lumaknot::validate
