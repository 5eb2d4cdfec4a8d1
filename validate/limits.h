/// How far a renderer's picture may lie from ours, and why.
#pragma once

#include <limits>
#include <string_view>

namespace lumaknot {

/// Errors are the largest difference of a pixel's three channels. Inside: covered in both images
/// and not at a silhouette.
struct Limits {
  std::string_view renderer;
  double edge = 0;  ///< pixels by which its samples may lie off the centre; a pixel covered in one
                    ///< image only needs an edge of the surface as near as that
  double mean = kNone, p999 = kNone, p9999 = kNone;  ///< inside, without classed outliers
  double outlier = kNone;                            ///< an error beyond it needs a class
  long long unexplained = 0;                         ///< outliers without a class
  std::string_view reason;

  static constexpr double kNone = std::numeric_limits<double>::infinity();
};

/// The limits of the renderer called `name`.
const Limits& limits_of(std::string_view name);

}  // namespace lumaknot
