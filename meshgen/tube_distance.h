/// The distance of a point to a nearby centre line.
#pragma once

#include "meshgen/curve.h"

namespace lumaknot {

/// The distance of `x` to the branch of `curve` near the parameter t, in scene units: the first
/// local minimum found by descending from there. `at` is the curve's point at t; where t is nearly
/// the foot already, no other point is computed. Relative error 1e-14 plus rounding.
double distance_near(const Curve& curve, const CurvePoint& at, double t, const Vec3d& x);

}  // namespace lumaknot
