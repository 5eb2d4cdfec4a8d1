/// The exact surface of a knot, as rays see it.
#pragma once

#include <vector>

#include "meshgen/spine.h"
#include "render/rasterizer.h"
#include "render/tube_rays.h"

namespace lumaknot {

/// What one ray sees of the exact tube.
struct ExactFragment {
  Fragment fragment;  ///< `triangle` is the component; no weights
  double t = 0;       ///< along the component, radians, in [0, 2 pi]
  double theta = 0;   ///< around the tube from the frame's `across`, radians, in [0, 2 pi)
  bool decided =
      true;  ///< false: the ray touches the tube within rounding, and may miss or meet it
};

/// The surface that the meshes of a knot approach as their grids become finer: the round tube about
/// each component, with the texture coordinates that its frames and its unwrapping give.
class ExactTube {
 public:
  /// Throws Error for numbers out of range, frames that are undefined, and knots whose meshes
  /// approach no round tube: three.js's and Babylon.js's frames tilt the rings against the centre
  /// line, whatever the grid.
  explicit ExactTube(const KnotSpec& knot);

  /// The nearest point of the ray farther than `beyond`, in lengths of its direction; with a
  /// direction of depth one, that is the depth.
  ExactFragment first(const Ray& ray, double beyond) const;

 private:
  KnotSpec knot_;
  std::vector<Spine> spines_;
  TubeRays rays_;
};

}  // namespace lumaknot
