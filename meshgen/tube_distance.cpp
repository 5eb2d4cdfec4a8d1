#include "meshgen/tube_distance.h"

#include <algorithm>
#include <cmath>

namespace lumaknot {
namespace {

/// |x - C(t + d)|^2 = gap - 2 slope d + bend d^2 + cubic d^3 + O(d^4).
struct Expansion {
  double gap, slope, bend, cubic;
};

Expansion expand(const CurvePoint& at, const Vec3d& x) {
  const Vec3d v = x - at.position;
  return {dot(v, v), dot(v, at.first), dot(at.first, at.first) - dot(v, at.second),
          dot(at.first, at.second) - dot(v, at.third) / 3};
}

/// Descends from t by Newton steps on (x - C) . C' = 0, shortened where they would climb.
double descend(const Curve& curve, double t, const Vec3d& x) {
  const double longest = 0.3 / (std::abs(curve.p) + std::abs(curve.q));
  Expansion here = expand(curve_point(curve, t), x);
  for (int i = 0; i < 100; ++i) {
    const double ahead = std::copysign(longest, here.slope);
    double step = here.bend > 0 ? here.slope / here.bend : ahead;
    if (std::abs(step) > longest) step = ahead;
    Expansion next = expand(curve_point(curve, t + step), x);
    while (next.gap > here.gap && std::abs(step) > 1e-9) {
      step /= 2;
      next = expand(curve_point(curve, t + step), x);
    }
    // A step so short changes the squared distance by its own square.
    if (std::abs(step) <= 1e-9) break;
    t += step;
    here = next;
  }
  return std::sqrt(here.gap);
}

}  // namespace

double distance_near(const Curve& curve, const CurvePoint& at, double t, const Vec3d& x) {
  const Expansion e = expand(at, x);
  if (e.bend > 0) {
    const double d = e.slope / e.bend;
    const double square = e.gap - e.slope * d + e.cubic * d * d * d;
    // The error of the step, and the order that the expansion leaves out.
    const double missed =
        (9 * e.cubic * e.cubic / (4 * e.bend) + dot(at.second, at.second)) * d * d * d * d;
    if (missed <= 1e-14 * square) return std::sqrt(square);
  }
  return descend(curve, t, x);
}

}  // namespace lumaknot
