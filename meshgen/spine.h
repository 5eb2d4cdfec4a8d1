/// A centre line with its arc length and its frame of minimal twist.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "meshgen/curve.h"

namespace lumaknot {

/// An orthonormal frame on the centre line: `normal` x `tangent` = `binormal`.
struct RingFrame {
  Vec3d position, tangent;
  Vec3d normal, binormal;  ///< span the ring's plane, normal at angle 0 of the tube
};

/// The integral of an even, smooth function of period 2 pi, to a few units in the last place of the
/// integral over a period: a Chebyshev series of degree 16 on each of as many panels as needed.
class PeriodicIntegral {
 public:
  explicit PeriodicIntegral(const std::function<double(double)>& function);
  /// From 0 to `x`, in radians.
  double operator()(double x) const;
  /// From 0 to 2 pi k / n for 0 <= k <= n.
  std::vector<double> table(int n) const;

 private:
  static constexpr int kDegree = 16;
  /// The integral from `from` to from + width (y + 1) / 2 is sum c_k T_k(y).
  struct Panel {
    double from, width;
    std::array<double, kDegree + 1> c;
  };

  double within(std::size_t panel, double x) const;
  void fit(const std::function<double(double)>& function, double from, double width,
           double tolerance, int depth);

  std::vector<Panel> panels_;    // of [0, pi]
  std::vector<double> sums_{0};  // the integral up to each panel, and to pi
};

/// One component's centre line. The rotation-minimising frame is at the angle
///   alpha(t) = p q R * integral of dt / |C'|
/// from the torus' normal (minus the integral of the geodesic torsion of a (p,q) curve on a torus,
/// do Carmo: Differential Geometry of Curves and Surfaces, 3-2); its mismatch after one loop is
/// distributed evenly over the arc length, so that the frame at 2 pi is the frame at 0.
class Spine {
 public:
  explicit Spine(const Curve& curve);

  const Curve& curve() const { return curve_; }
  double length() const { return length_; }  ///< in scene units

  /// The arc length from 0 to t, in scene units; t in radians, also beyond one loop.
  double arc_length(double t) const;

  /// The angle in [-pi, pi], about the tangent, between the rotation-minimising frame before and
  /// after one loop.
  double holonomy() const { return holonomy_; }

  /// The closed frame at t, with an error of about 1e-15 radians per turn.
  RingFrame frame(double t) const;

  /// arc_length() at the rings t = 2 pi i / n, 0 <= i <= n, at much lower cost.
  std::vector<double> arc_lengths(int n) const;
  /// frame() at the rings of `arc_lengths`, the result of arc_lengths().
  std::vector<RingFrame> frames(std::span<const double> arc_lengths) const;

 private:
  std::vector<double> at_rings(const PeriodicIntegral& integral, int n) const;
  double integral_of(const PeriodicIntegral& integral, double start, double t) const;
  double min_twist(double t) const;
  double twist_rate() const { return curve_.p * curve_.q * curve_.major_radius; }
  RingFrame frame_at(const TorusAngles& at, double twist, double arc_length) const;

  Curve curve_;
  PeriodicIntegral speed_, slowness_;
  double speed_start_ = 0, slowness_start_ = 0;  // the integrals up to the meridian's phase
  double length_ = 0, holonomy_ = 0;
};

}  // namespace lumaknot
