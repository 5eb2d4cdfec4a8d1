#include "meshgen/curve.h"

#include <fmt/format.h>

#include <numeric>

#include "math/angle.h"
#include "system/error.h"

namespace lumaknot {

std::vector<Curve> components(const KnotSpec& knot) {
  const int count = std::gcd(knot.p, knot.q);
  std::vector<Curve> curves;
  for (int k = 0; k < count; ++k) {
    Curve curve{knot.p / count, knot.q / count, knot.major_radius, knot.minor_radius};
    const double phase = kTurn * k;
    (knot.q != 0 ? curve.longitude : curve.meridian) = phase / std::abs(knot.q ? knot.q : knot.p);
    // Only circles about the axis can shrink to a point, when they lie on it.
    const double size = knot.major_radius + knot.minor_radius;
    if (knot.q == 0 && speed(curve, 0) <= 1e-12 * size) {
      throw Error(
          fmt::format("component {} of the ({},{}) link lies on the axis and has no extent; "
                      "change the ring's radius {} or the winding's {}",
                      k + 1, knot.p, knot.q, knot.major_radius, knot.minor_radius));
    }
    curves.push_back(curve);
  }
  return curves;
}

SinCos sin_cos(double angle) { return {std::cos(angle), std::sin(angle)}; }

std::vector<SinCos> sin_cos_table(int n) {
  std::vector<SinCos> result(static_cast<std::size_t>(n));
  for (int k = 0; 2 * k <= n; ++k) {
    const SinCos here = sin_cos(ring_parameter(k, n));
    result[std::size_t((n - k) % n)] = {here.c, -here.s};
    result[std::size_t(k)] = here;
  }
  return result;
}

TorusAngles torus_angles(const Curve& curve, double t) {
  return {sin_cos(curve.p * t + curve.longitude), sin_cos(curve.q * t + curve.meridian)};
}

std::vector<TorusAngles> ring_angles(const Curve& curve, int n) {
  const std::vector<SinCos> parts = sin_cos_table(n);
  const TorusAngles phase = torus_angles(curve, 0);
  Winding around(curve.p, n), through(curve.q, n);
  std::vector<TorusAngles> angles;
  angles.reserve(parts.size() + 1);
  for (int i = 0; i <= n; ++i) {
    angles.push_back(
        {sum(parts[around.part()], phase.longitude), sum(parts[through.part()], phase.meridian)});
    around.advance();
    through.advance();
  }
  return angles;
}

CurvePoint curve_point(const Curve& curve, double t) {
  return curve_point(curve, torus_angles(curve, t));
}

double ring_parameter(int i, int n) { return kTurn * i / n; }

double speed(const Curve& curve, double t) {
  const double reach =
      curve.major_radius + curve.minor_radius * std::cos(curve.q * t + curve.meridian);
  return std::hypot(curve.minor_radius * curve.q, reach * curve.p);
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
