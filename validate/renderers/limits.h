/// How far a renderer's picture may differ from ours, and why.
#pragma once

#include <limits>
#include <string_view>

namespace lumaknot::validate {

/// An error is the largest difference of a pixel's three channels; inside means covered in both
/// images and not at a silhouette.
struct Limits {
  double edge = 0;  ///< pixels by which its samples may be off the centre; a pixel covered in only
                    ///< one image needs an edge of the surface as near as that
  double mean = kNone, p999 = kNone, p9999 = kNone;  ///< inside, without classified outliers
  double outlier = kNone;                            ///< a larger error needs a class
  double unexplained = 0;  ///< outliers without a class, as a share of the silhouette's length
  std::string_view reason;

  static constexpr double kNone = std::numeric_limits<double>::infinity();
};

}  // namespace lumaknot::validate
