// Filip, Magedson, Markot: Surface algorithms using bounds on derivatives, CAGD 3 (1986): over a
// right triangle with the legs h and k a function is within
//   (h^2 M_tt + 2 h k M_tk + k^2 M_kk) / 8
// of its linear interpolant, M bounding its second derivatives.
//
// The derivatives of the tube X = C + r n follow from n' = s (-kn T + w b), b' = s (-kb T - w n),
// where b = dn/dtheta, s = |C'|, K = kn n + kb b is the curvature vector and w the frame's rotation
// per unit length. Bounds on an interval of t are those at its middle plus half its width times a
// bound of the next derivative.
// the next derivative.
#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "meshgen/deviation.h"

namespace lumaknot {
namespace {

/// Upper bounds of |C''|, |C'''|, |C''''| on the whole curve, from its harmonics.
struct GlobalBounds {
  double second, third, fourth;
};

GlobalBounds global_bounds(const Curve& curve) {
  const double p = std::abs(curve.p), q = std::abs(curve.q), w = curve.minor_radius;
  const auto bound = [&](double k) {
    return std::hypot(std::pow(p, k) * curve.major_radius + std::pow(p + q, k) * w,
                      std::pow(q, k) * w);
  };
  return {bound(2), bound(3), bound(4)};
}

/// Bounds on an interval of t: |C'| from above and its derivative, the curvature and |K'|.
struct SpineBounds {
  double speed = 0, speed_rate = 0, curvature = 0, curvature_rate = 0;
};

/// The curvature vector K and its derivative with respect to t.
struct CurvatureVector {
  Vec3d value, rate;
};

CurvatureVector curvature_vector(const CurvePoint& c) {
  const double s2 = dot(c.first, c.first), slope = dot(c.first, c.second);
  const double slope_rate = dot(c.second, c.second) + dot(c.first, c.third);
  // K = (s^2 C'' - (C' . C'') C') / s^4.
  const Vec3d above = c.second * s2 - c.first * slope;
  const Vec3d above_rate = c.third * s2 + c.second * slope - c.first * slope_rate;
  return {above / (s2 * s2), (above_rate - above * (4 * slope / s2)) / (s2 * s2)};
}

/// A bound of |K''| where s >= `min`: Leibniz' rule on s T = C' and s K = T', the derivatives of s
/// from s s' = C' . C''. All in units of the speed.
double curvature_acceleration(double min, double second, double third, double fourth) {
  const double a = second / min, b = third / min, c = fourth / min;
  const double s1 = a, s2 = a * a + b, s3 = c + 3 * a * b + 3 * s1 * s2;
  const double t1 = a, t2 = b + 2 * s1 * t1 + s2, t3 = c + 3 * s1 * t2 + 3 * s2 * t1 + s3;
  const double k0 = t1, k1 = t2 + s1 * k0, k2 = t3 + 2 * s1 * k1 + s2 * k0;
  return k2 / min;
}

SpineBounds spine_bounds(const Curve& curve, const GlobalBounds& global, double middle,
                         double half) {
  const CurvePoint c = curve_point(curve, middle);
  const double third = std::min(global.third, length(c.third) + half * global.fourth);
  const double second = std::min(global.second, length(c.second) + half * third);
  const double rate = std::abs(dot(c.first, c.second)) / length(c.first);
  const double reach = std::abs(curve.p) * (curve.major_radius - curve.minor_radius);
  const double min =
      std::max({length(c.first) - half * second, std::abs(curve.q) * curve.minor_radius, reach});
  const CurvatureVector k = curvature_vector(c);
  SpineBounds bounds;
  bounds.speed_rate = std::min(second, rate + half * (second * second / min + third));
  bounds.speed = length(c.first) + half * bounds.speed_rate;
  bounds.curvature_rate =
      length(k.rate) + half * curvature_acceleration(min, second, third, global.fourth);
  bounds.curvature = length(k.value) + half * bounds.curvature_rate;
  return bounds;
}

SpineBounds larger(const SpineBounds& a, const SpineBounds& b) {
  return {std::max(a.speed, b.speed), std::max(a.speed_rate, b.speed_rate),
          std::max(a.curvature, b.curvature), std::max(a.curvature_rate, b.curvature_rate)};
}

/// Bounds of second derivatives: of all of them, and of the part that contributes to first order to
/// the errors of the chord or the angle.
struct SecondBounds {
  double tt, tk, kk;
};

/// The cell's legs in radians.
struct Cell {
  double h, k;
  double interpolation_error(const SecondBounds& m) const {
    return (h * h * m.tt + 2 * h * k * m.tk + k * k * m.kk) / 8;
  }
};

/// The frame's rotation per unit length, and the tube's radius.
struct Tube {
  double turn, radius;
};

/// |d - r| at a point E off the tube's point X is at most |E|, and to first order the component of
/// E along the normal n there: at most |E . n| + |E|^2 / 2 times a bound of d's second derivative.
/// n turns by no more than `tilt` in the cell.
struct PlaceBound {
  double offset = 0, chord = 0;  ///< |E| and its effect on the distance
};

PlaceBound place_bound(const SpineBounds& b, const Tube& tube, const Cell& cell, double tilt) {
  const double r = tube.radius, w = tube.turn, s = b.speed, bend = s * s * b.curvature;
  const double swell = 1 + r * b.curvature;
  const double inward = bend * swell + r * w * w * s * s;  // X_tt . n
  // (s (1 - r kn))' - r w s^2 kb along T, s^2 (1 - r kn) kb + r w s' along b.
  const double along =
      b.speed_rate * swell + r * s * (b.curvature_rate + s * w * b.curvature) + r * w * bend;
  const double whole = std::hypot(inward, along, bend * swell + r * w * b.speed_rate);
  const double mixed = r * s * std::hypot(b.curvature, w);
  const double off = cell.interpolation_error({whole, mixed, r});
  const double normal =
      cell.interpolation_error({std::min(whole, inward + tilt * whole),
                                std::min(mixed, r * s * (w + tilt * b.curvature)), r});
  const double focus = 1 - b.curvature * (r + off);
  if (off >= r || focus <= 0) return {off, off};
  return {off,
          std::min(off, normal + off * off / 2 * std::max(1 / (r - off), b.curvature / focus))};
}

/// The angle between N and N + E is at most atan(component of E normal to N / (1 - |E|)).
double normal_bound(const SpineBounds& b, const Tube& tube, const Cell& cell, double tilt) {
  const double w = tube.turn, s = b.speed, bend = s * s * b.curvature;
  const double along =
      b.speed_rate * b.curvature + s * (b.curvature_rate + s * w * b.curvature) + w * bend;
  const double around = bend * b.curvature / 2 + w * b.speed_rate;
  const double inward = s * s * (b.curvature * b.curvature + w * w);
  const double whole = std::hypot(along, around, inward), mixed = s * std::hypot(b.curvature, w);
  const double off = cell.interpolation_error({whole, mixed, 1});
  if (off >= 1) return kPi;
  const double across = cell.interpolation_error(
      {std::min(whole, std::hypot(along, around) + tilt * inward),
       std::min(mixed, s * (b.curvature + tilt * w)), std::min(tilt, 1.0)});
  return std::min(std::asin(off), std::atan(across / (1 - off)));
}

}  // namespace

DeviationBound deviation_bound(const TubeSurface& surface, int segments, int sides) {
  constexpr int kPieces = 8;  // per segment, for narrower intervals
  const Spine& spine = surface.spine();
  const Tube tube{std::abs(spine.holonomy()) / spine.length(), surface.tube_radius()};
  const Cell cell{2 * kPi / segments, 2 * kPi / sides};
  const GlobalBounds global = global_bounds(spine.curve());
  DeviationBound worst;
  for (int i = 0; i < segments; ++i) {
    SpineBounds bounds;
    for (int piece = 0; piece < kPieces; ++piece) {
      const double middle = cell.h * (i + (piece + 0.5) / kPieces);
      bounds = larger(bounds, spine_bounds(spine.curve(), global, middle, cell.h / kPieces / 2));
    }
    const double tilt = cell.h * bounds.speed * std::hypot(bounds.curvature, tube.turn) + cell.k;
    const PlaceBound place = place_bound(bounds, tube, cell, tilt);
    worst.chord = std::max(worst.chord, place.chord);
    worst.offset = std::max(worst.offset, place.offset);
    const double angle = normal_bound(bounds, tube, cell, tilt) * 180 / kPi;
    worst.normal_degrees = std::max(worst.normal_degrees, angle);
  }
  // A triangle's points and the centre line lie in balls about the origin, whatever the steps.
  const double reach = spine.curve().major_radius + spine.curve().minor_radius;
  const double extent = std::max(2 * reach, tube.radius);
  worst.chord = std::min(worst.chord, extent);
  worst.offset = std::min(worst.offset, 2 * (reach + tube.radius));
  return worst;
}

}  // namespace lumaknot
