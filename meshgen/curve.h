/// The centre line: a (p,q) torus knot about +Z.
#pragma once

#include "scene/scene.h"

namespace lumaknot {

/// A point of the curve and its derivative by the parameter.
struct CurvePoint {
  Vec3d position;    ///< scene units
  Vec3d derivative;  ///< scene units a radian, never zero for a valid knot
};

/// C(t) = ((R + w cos qt) cos pt, (R + w cos qt) sin pt, w sin qt), period 2 pi, exact derivative.
CurvePoint curve_point(const KnotSpec& knot, double t);

/// The curve's length, by the trapezoid rule on `samples` points, which converges faster than any
/// power on a smooth closed curve.
double curve_length(const KnotSpec& knot, int samples = 4096);

}  // namespace lumaknot
