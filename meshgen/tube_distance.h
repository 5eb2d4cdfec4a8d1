/// The distance of a point to a centre line that it is near.
#pragma once

#include "meshgen/curve.h"

namespace lumaknot {

/// The distance of `x` to the branch of `curve` near the parameter t, in scene units: to the first
/// least distance that descends from there. `at` is the curve's point at t; where t is nearly the
/// foot already, no other point is computed. Relative error 1e-14 and rounding.
double distance_near(const Curve& curve, const CurvePoint& at, double t, const Vec3d& x);

}  // namespace lumaknot
