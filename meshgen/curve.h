/// Centre lines: the components of a (p,q) torus link about +Z.
#pragma once

#include <vector>

#include "scene/spec.h"

namespace lumaknot {

/// One closed component: with longitude phi = p t + longitude, meridian psi = q t + meridian, R the
/// major radius and w the minor radius,
///   C(t) = ((R + w cos psi) cos phi, (R + w cos psi) sin phi, w sin psi),  0 <= t <= 2 pi.
struct Curve {
  int p = 2, q = 3;  ///< coprime; not both zero
  double major_radius = 1, minor_radius = 0.4;
  double longitude = 0, meridian = 0;  ///< phases, radians
};

/// The gcd(|p|, |q|) components of `knot`: each is the previous one rotated about the axis by 2 pi
/// / |q| or, when q is zero, about the ring's circle by 2 pi / |p|. Throws Error when a component
/// has no extent.
std::vector<Curve> components(const KnotSpec& knot);

/// The cosine and the sine of an angle.
struct SinCos {
  double c = 1, s = 0;
};

SinCos sin_cos(double angle);

/// The table of the angles 2 pi k / n, 0 <= k < n.
std::vector<SinCos> sin_cos_table(int n);

/// The sum of two angles.
inline SinCos sum(SinCos a, SinCos b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }

/// The longitude and the meridian of a point on a curve.
struct TorusAngles {
  SinCos longitude, meridian;
};

/// The angles at the parameter t, in radians.
TorusAngles torus_angles(const Curve& curve, double t);

/// The angles at t = 2 pi i / n for 0 <= i <= n.
std::vector<TorusAngles> ring_angles(const Curve& curve, int n);

/// The multiples of `step` n-ths of a turn: whole turns, and a remainder of 0 to n - 1.
class Winding {
 public:
  Winding(int step, int n)
      : n_(n), part_step_((step % n + n) % n), turn_step_((step - part_step_) / n) {}

  std::size_t part() const { return std::size_t(part_); }
  double revolutions() const { return double(revolutions_); }
  void advance() {
    part_ += part_step_;
    revolutions_ += turn_step_ + (part_ >= n_);
    if (part_ >= n_) part_ -= n_;
  }

 private:
  long long n_, part_step_, turn_step_, part_ = 0, revolutions_ = 0;
};

/// A point of the curve and its exact derivatives with respect to the parameter, in scene units per
/// radian^k.
struct CurvePoint {
  Vec3d position, first, second, third;
};

/// The point at these angles. Inline, so that the derivatives cost nothing where only the position
/// is used.
inline CurvePoint curve_point(const Curve& curve, const TorusAngles& at) {
  const auto& [longitude, meridian] = at;
  const double p = curve.p, q = curve.q, w = curve.minor_radius;
  const Vec3d out{longitude.c, longitude.s, 0}, along{-longitude.s, longitude.c, 0};
  // The distance from the axis and the height, with their derivatives.
  const double cp = meridian.c, sp = meridian.s;
  const double r0 = curve.major_radius + w * cp, r1 = -w * q * sp, r2 = -w * q * q * cp;
  const double r3 = w * q * q * q * sp;
  // (r out)' = r' out + r p along, as out' = p along and along' = -p out.
  return {out * r0 + Vec3d{0, 0, w * sp}, out * r1 + along * (p * r0) + Vec3d{0, 0, w * q * cp},
          out * (r2 - p * p * r0) + along * (2 * p * r1) + Vec3d{0, 0, -w * q * q * sp},
          out * (r3 - 3 * p * p * r1) + along * (3 * p * r2 - p * p * p * r0) +
              Vec3d{0, 0, -w * q * q * q * cp}};
}

/// The point at the parameter t, in radians.
CurvePoint curve_point(const Curve& curve, double t);

/// The parameter 2 pi i / n for 0 <= i <= n.
double ring_parameter(int i, int n);

/// |C'(t)|, in scene units per radian.
double speed(const Curve& curve, double t);

/// |C' x C''| / |C'|^3, in 1 / scene units.
double curvature(const CurvePoint& point);

/// (C' x C'') . C''' / |C' x C''|^2, in 1 / scene units; not a number where the curvature is zero.
double torsion(const CurvePoint& point);

}  // namespace lumaknot
