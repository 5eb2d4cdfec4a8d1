#include "meshgen/curve.h"

#include <numbers>

namespace lumaknot {

CurvePoint curve_point(const KnotSpec& knot, double t) {
  const double cp = std::cos(knot.p * t), sp = std::sin(knot.p * t);
  const double cq = std::cos(knot.q * t), sq = std::sin(knot.q * t);
  const double w = knot.winding_radius;
  const double reach = knot.ring_radius + w * cq;  // distance from the axis
  const double reach_rate = -w * knot.q * sq;
  return {{reach * cp, reach * sp, w * sq},
          {reach_rate * cp - reach * knot.p * sp, reach_rate * sp + reach * knot.p * cp,
           w * knot.q * cq}};
}

double curve_length(const KnotSpec& knot, int samples) {
  const double step = 2 * std::numbers::pi / samples;
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += length(curve_point(knot, i * step).derivative);
  return sum * step;
}

}  // namespace lumaknot
