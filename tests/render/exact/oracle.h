/// The exact tube again, in extended precision and from the textbook: the oracle for the truth.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "meshgen/curve.h"
#include "render/exact/tube_rays.h"

namespace lumaknot::testing {

using Extended = long double;
using Vec3x = Vec3<Extended>;

inline Vec3x extended(const Vec3d& v) { return {v.x, v.y, v.z}; }
inline Vec3d plain(const Vec3x& v) { return {double(v.x), double(v.y), double(v.z)}; }

inline constexpr Extended kPiX = std::numbers::pi_v<Extended>;

/// C and its first two derivatives at t.
struct ExtendedPoint {
  Vec3x position, first, second;
};

/// From cos(A) cos(B) = (cos(A + B) + cos(A - B)) / 2: sums of plain waves, differentiated one by
/// one.
inline ExtendedPoint extended_point(const Curve& c, Extended t) {
  ExtendedPoint point{};
  const auto add = [&](Extended size, Extended rate, Extended phase) {
    const Extended x = std::cos(rate * t + phase), y = std::sin(rate * t + phase);
    point.position = point.position + Vec3x{x, y, 0} * size;
    point.first = point.first + Vec3x{-y, x, 0} * (size * rate);
    point.second = point.second - Vec3x{x, y, 0} * (size * rate * rate);
  };
  const Extended p = c.p, q = c.q, w = c.minor_radius, lon = c.longitude, mer = c.meridian;
  add(c.major_radius, p, lon);
  add(w / 2, p + q, lon + mer);
  add(w / 2, p - q, lon - mer);
  const Extended rise = std::sin(q * t + mer), run = std::cos(q * t + mer);
  point.position.z = w * rise;
  point.first.z = w * q * run;
  point.second.z = -w * q * q * rise;
  return point;
}

/// A point of a ray on a tube.
struct ExtendedHit {
  Extended distance, t;
  Vec3x position, normal;
};

/// The point that Newton's method in (t, s) reaches from a hit: |P - C|^2 = r^2, (P - C).C' = 0.
inline ExtendedHit polished(const Curve& curve, double radius, const exact::Ray& ray,
                            const exact::TubeHit& hit) {
  const Vec3x origin = extended(ray.origin), direction = extended(ray.direction);
  Extended t = hit.t, s = hit.distance;
  for (int i = 0; i < 8; ++i) {
    const ExtendedPoint c = extended_point(curve, t);
    const Vec3x spoke = origin + direction * s - c.position;
    const Extended f = dot(spoke, spoke) - Extended(radius) * radius, g = dot(spoke, c.first);
    const Extended f_t = -2 * g, f_s = 2 * dot(spoke, direction);
    const Extended g_t = dot(spoke, c.second) - dot(c.first, c.first),
                   g_s = dot(direction, c.first);
    const Extended determinant = f_t * g_s - f_s * g_t;
    t -= (f * g_s - g * f_s) / determinant;
    s -= (g * f_t - f * g_t) / determinant;
  }
  const Vec3x position = origin + direction * s;
  return {s, t, position, normalize(position - extended_point(curve, t).position)};
}

/// G = |a w + b d|^2 - r^2 a^2 with w = o - C, a = d.C', b = -w.C': zero at the hits' t, with a
/// change of sign unless two meet.
inline Extended meeting(const Curve& curve, double radius, const exact::Ray& ray, Extended t) {
  const ExtendedPoint c = extended_point(curve, t);
  const Vec3x d = extended(ray.direction), w = extended(ray.origin) - c.position;
  const Extended a = dot(d, c.first), b = -dot(w, c.first);
  const Vec3x sum = w * a + d * b;
  return dot(sum, sum) - Extended(radius) * radius * a * a;
}

/// The signs of G that change between `steps` points of one loop.
inline int changes_of_sign(const Curve& curve, double radius, const exact::Ray& ray, int steps) {
  int changes = 0;
  bool last = meeting(curve, radius, ray, 0.0001L) > 0;
  for (int i = 1; i <= steps; ++i) {
    const bool next = meeting(curve, radius, ray, 0.0001L + 2 * kPiX * i / steps) > 0;
    changes += next != last;
    last = next;
  }
  return changes;
}

/// The integral of f from 0 to t: Gauss' rule of five points on `panels` panels.
template <class F>
Extended integral(const F& f, Extended t, int panels) {
  static const Extended kX[] = {0, std::sqrt(5 - 2 * std::sqrt(10.0L / 7)) / 3,
                                std::sqrt(5 + 2 * std::sqrt(10.0L / 7)) / 3};
  static const Extended kW[] = {128.0L / 225, (322 + 13 * std::sqrt(70.0L)) / 900,
                                (322 - 13 * std::sqrt(70.0L)) / 900};
  Extended sum = 0;
  const Extended half = t / panels / 2;
  for (int i = 0; i < panels; ++i) {
    const Extended middle = half * (2 * i + 1);
    sum += kW[0] * f(middle);
    for (int k = 1; k < 3; ++k) {
      sum += kW[k] * (f(middle - half * kX[k]) + f(middle + half * kX[k]));
    }
  }
  return sum * half;
}

/// Arc length, and the angle of the closed minimum-twist frame from the torus' normal.
struct ExtendedFrame {
  Extended share;          ///< of the arc length
  Vec3x normal, binormal;  ///< at angle 0 of the tube and a quarter on
};

inline ExtendedFrame extended_frame(const Curve& curve, Extended t) {
  constexpr int kPanels = 100;
  const auto speed_at = [&](Extended x) { return length(extended_point(curve, x).first); };
  const auto turning = [&](Extended x) {
    return Extended(curve.p) * curve.q * curve.major_radius / speed_at(x);
  };
  const Extended whole = integral(speed_at, 2 * kPiX, kPanels);
  const Extended missing = std::remainder(integral(turning, 2 * kPiX, kPanels), 2 * kPiX);
  const Extended share = integral(speed_at, t, kPanels) / whole;
  const Extended angle = integral(turning, t, kPanels) - missing * share;
  const ExtendedPoint point = extended_point(curve, t);
  const Vec3x tangent = normalize(point.first);
  const Extended lon = curve.p * t + curve.longitude, mer = curve.q * t + curve.meridian;
  const Vec3x out{std::cos(mer) * std::cos(lon), std::cos(mer) * std::sin(lon), std::sin(mer)};
  const Vec3x normal = out * std::cos(angle) + cross(tangent, out) * std::sin(angle);
  return {share, normal, cross(normal, tangent)};
}

}  // namespace lumaknot::testing
