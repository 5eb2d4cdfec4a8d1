/// The exact surface of a knot, for ray queries.
#pragma once

#include <vector>

#include "meshgen/spine.h"
#include "render/exact/tube_rays.h"
#include "render/rasterizer.h"

namespace lumaknot::exact {

/// The exact tube's point seen by one ray.
struct ExactFragment {
  Fragment fragment;    ///< `triangle` is the component; no weights
  double t = 0;         ///< along the component, radians, in [0, 2 pi]
  double theta = 0;     ///< around the tube from the ring frame's normal, radians, in [0, 2 pi)
  bool decided = true;  ///< false: the ray touches the tube within rounding, so may hit or miss it
};

/// The surface that the meshes of a knot approach as their grids become finer: the round tube about
/// each component, with the texture coordinates given by its ring frames and its unwrapping.
class ExactTube {
 public:
  /// Throws Error for numbers out of range, undefined frames, and knots whose meshes approach no
  /// round tube: three.js's and Babylon.js's frames tilt the rings against the centre line,
  /// whatever the grid.
  explicit ExactTube(const KnotSpec& knot);

  /// The nearest hit farther than `beyond`, in lengths of the ray's direction; with a direction of
  /// depth one, that is the depth.
  ExactFragment first(const Ray& ray, double beyond) const;

 private:
  KnotSpec knot_;
  std::vector<Spine> spines_;
  TubeRays rays_;
};

}  // namespace lumaknot::exact
