#include "meshgen/curve.h"

#include <fmt/format.h>

#include <numbers>
#include <numeric>

#include "scene/error.h"

namespace lumaknot {

std::vector<Curve> components(const KnotSpec& knot) {
  const int count = std::gcd(knot.p, knot.q);
  std::vector<Curve> curves;
  for (int k = 0; k < count; ++k) {
    Curve curve{knot.p / count, knot.q / count, knot.ring_radius, knot.winding_radius};
    const double phase = 2 * std::numbers::pi * k;
    (knot.q != 0 ? curve.longitude : curve.meridian) = phase / std::abs(knot.q ? knot.q : knot.p);
    // Only circles about the axis can shrink to a point, when they lie on it.
    const double size = knot.ring_radius + knot.winding_radius;
    if (knot.q == 0 && speed(curve, 0) <= 1e-12 * size) {
      throw Error(
          fmt::format("component {} of the ({},{}) link lies on the axis and has no extent; "
                      "change the ring's radius {} or the winding's {}",
                      k + 1, knot.p, knot.q, knot.ring_radius, knot.winding_radius));
    }
    curves.push_back(curve);
  }
  return curves;
}

CurvePoint curve_point(const Curve& curve, double t) {
  const double p = curve.p, q = curve.q, w = curve.winding_radius;
  const double phi = p * t + curve.longitude, psi = q * t + curve.meridian;
  const Vec3d out{std::cos(phi), std::sin(phi), 0}, along{-out.y, out.x, 0};
  // The distance from the axis and the height, with their derivatives.
  const double cp = std::cos(psi), sp = std::sin(psi);
  const double r0 = curve.ring_radius + w * cp, r1 = -w * q * sp, r2 = -w * q * q * cp;
  const double r3 = w * q * q * q * sp;
  // (r out)' = r' out + r p along, as out' = p along and along' = -p out.
  return {out * r0 + Vec3d{0, 0, w * sp}, out * r1 + along * (p * r0) + Vec3d{0, 0, w * q * cp},
          out * (r2 - p * p * r0) + along * (2 * p * r1) + Vec3d{0, 0, -w * q * q * sp},
          out * (r3 - 3 * p * p * r1) + along * (3 * p * r2 - p * p * p * r0) +
              Vec3d{0, 0, -w * q * q * q * cp}};
}

double ring_parameter(int i, int n) { return 2 * std::numbers::pi * i / n; }

double speed(const Curve& curve, double t) {
  const double reach =
      curve.ring_radius + curve.winding_radius * std::cos(curve.q * t + curve.meridian);
  return std::hypot(curve.winding_radius * curve.q, reach * curve.p);
}

double curvature(const CurvePoint& point) {
  const double rate = length(point.first);
  return length(cross(point.first, point.second)) / (rate * rate * rate);
}

double torsion(const CurvePoint& point) {
  const Vec3d binormal = cross(point.first, point.second);
  return dot(binormal, point.third) / dot(binormal, binormal);
}

}  // namespace lumaknot
