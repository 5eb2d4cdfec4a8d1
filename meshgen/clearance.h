/// How thick a tube about a link may be.
#pragma once

#include <vector>

#include "meshgen/curve.h"

namespace lumaknot {

/// Where the tube about a link first touches itself as it grows.
struct Clearance {
  /// The largest tube radius that touches nowhere, in scene units. It is never too small, and too
  /// large by at most 1e-6 of itself plus the rounding of positions, about 1e-15 (|p| + |q|) (R +
  /// w). Zero where the centre line meets itself.
  double radius = 0;
  /// Whether the curvature of the centre line sets the limit (also if two strands do as well);
  /// otherwise two strands that pass each other do.
  bool bends = false;
  int component_a = 0, component_b = 0;  ///< where, from 0; equal where it bends
  double t_a = 0, t_b = 0;               ///< parameters in [0, 2 pi); equal where it bends
};

/// The thickness of a link: the smallest radius of curvature, or half of the smallest distance
/// between two points whose chord is perpendicular to both tangents (Litherland, Simon, Durumeric,
/// Rawdon: Thickness of knots, 1999; Gonzalez and Maddocks: Global curvature, thickness, and the
/// ideal shapes of knots, 1999). `link` is the result of components(), optionally with all
/// longitudes and all meridians shifted equally; it must not be empty.
Clearance clearance(const std::vector<Curve>& link);

}  // namespace lumaknot
