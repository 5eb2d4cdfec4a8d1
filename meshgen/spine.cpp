#include "meshgen/spine.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace lumaknot {
namespace {

constexpr double kPi = std::numbers::pi;
using Gauss = boost::math::quadrature::gauss<double, 15>;

/// |C'| by the meridian angle alone.
double speed_at_meridian(const Curve& curve, double psi) {
  const double reach = curve.ring_radius + curve.winding_radius * std::cos(psi);
  return std::hypot(curve.winding_radius * curve.q, reach * curve.p);
}

}  // namespace

PeriodicIntegral::PeriodicIntegral(std::function<double(double)> function)
    : function_(std::move(function)) {
  halve(0, kPi, Gauss::integrate(function_, 0.0, kPi), 0);
}

void PeriodicIntegral::halve(double from, double to, double whole, int depth) {
  constexpr int kDeepest = 40;  // a panel of 3e-12 radians
  const double middle = from + (to - from) / 2;
  const double left = Gauss::integrate(function_, from, middle);
  const double right = Gauss::integrate(function_, middle, to);
  if (depth < kDeepest && std::abs(left + right - whole) > 1e-15 * std::abs(whole)) {
    halve(from, middle, left, depth + 1);
    halve(middle, to, right, depth + 1);
    return;
  }
  ends_.push_back(to);
  sums_.push_back(sums_.back() + left + right);
}

double PeriodicIntegral::operator()(double x) const {
  const double periods = std::round(x / (2 * kPi));
  const double rest = std::clamp(x - 2 * kPi * periods, -kPi, kPi), size = std::abs(rest);
  const auto panel = std::ranges::upper_bound(ends_, size) - ends_.begin() - 1;
  double sum = sums_[std::size_t(panel)];
  const double from = ends_[std::size_t(panel)];
  if (size > from) sum += Gauss::integrate(function_, from, size);
  return 2 * periods * sums_.back() + std::copysign(sum, rest);
}

Spine::Spine(const Curve& curve)
    : curve_(curve),
      speed_([curve](double psi) { return speed_at_meridian(curve, psi); }),
      slowness_([curve](double psi) { return 1 / speed_at_meridian(curve, psi); }) {
  length_ = arc_length(2 * kPi);
  const double turn = least_twist(2 * kPi);
  holonomy_ = std::remainder(turn, 2 * kPi);
  turns_ = int(std::lround((turn - holonomy_) / (2 * kPi)));
}

double Spine::integral_of(const PeriodicIntegral& integral, double t) const {
  return (integral(curve_.q * t + curve_.meridian) - integral(curve_.meridian)) / curve_.q;
}

double Spine::arc_length(double t) const {
  return curve_.q == 0 ? t * speed(curve_, 0) : integral_of(speed_, t);
}

double Spine::least_twist(double t) const {
  return curve_.q == 0 ? 0 : curve_.p * curve_.q * curve_.ring_radius * integral_of(slowness_, t);
}

Frame Spine::frame(double t) const {
  const CurvePoint point = curve_point(curve_, t);
  const double phi = curve_.p * t + curve_.longitude, psi = curve_.q * t + curve_.meridian;
  const Vec3d tangent = normalize(point.first);
  const Vec3d normal{std::cos(psi) * std::cos(phi), std::cos(psi) * std::sin(phi), std::sin(psi)};
  const Vec3d side = cross(tangent, normal);
  const double alpha = least_twist(t) - holonomy_ * (arc_length(t) / length_);
  const double c = std::cos(alpha), s = std::sin(alpha);
  const Vec3d across = normal * c + side * s;
  return {point.position, tangent, across, cross(across, tangent)};
}

}  // namespace lumaknot
