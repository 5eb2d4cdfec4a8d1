#include "meshgen/spine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lumaknot {
namespace {

constexpr double kPi = std::numbers::pi;

/// |C'| by the meridian angle alone.
double speed_at_meridian(const Curve& curve, double psi) {
  const double reach = curve.ring_radius + curve.winding_radius * std::cos(psi);
  return std::hypot(curve.winding_radius * curve.q, reach * curve.p);
}

/// The unit normal of the torus under the curve.
Vec3d torus_normal(const Curve& curve, double t) {
  const double phi = curve.p * t + curve.longitude, psi = curve.q * t + curve.meridian;
  return {std::cos(psi) * std::cos(phi), std::cos(psi) * std::sin(phi), std::sin(psi)};
}

/// cos(k (i + 1/2) pi / degree) in row i, column k.
template <int degree>
std::array<std::array<double, degree>, degree> chebyshev_cosines() {
  std::array<std::array<double, degree>, degree> table;
  for (int i = 0; i < degree; ++i) {
    const double angle = kPi * (i + 0.5) / degree;
    for (int k = 0; k < degree; ++k) table[std::size_t(i)][std::size_t(k)] = std::cos(k * angle);
  }
  return table;
}

}  // namespace

PeriodicIntegral::PeriodicIntegral(const std::function<double(double)>& function) {
  double sum = 0;
  for (int i = 0; i < kDegree; ++i) sum += std::abs(function(kPi * (i + 0.5) / kDegree));
  fit(function, 0, kPi, 4e-15 * kPi * sum / kDegree, 0);
}

// The series a_k of the function, k < kDegree, from its values at the Chebyshev points; that of its
// integral has c_k = (a_(k-1) - a_(k+1)) / (2 k) times half the width.
void PeriodicIntegral::fit(const std::function<double(double)>& function, double from, double width,
                           double tolerance, int depth) {
  constexpr int kDeepest = 20;  // a panel of 3e-6 radians
  static const auto kCosines = chebyshev_cosines<kDegree>();
  std::array<double, kDegree + 2> a{};
  for (const auto& cosines : kCosines) {
    const double value = function(from + width * (cosines[1] + 1) / 2);
    for (std::size_t k = 0; k < kDegree; ++k) {
      a[k] += value * cosines[k] * (k == 0 ? 1.0 : 2.0) / kDegree;
    }
  }
  const double tail = std::abs(a[kDegree - 1]) + std::abs(a[kDegree - 2]);
  // Of the whole integral, not of the panel's: a steep function's own rounding stays below it. The
  // integral divides these by 2 k besides: 1e-16 of it is left.
  if (depth < kDeepest && tail * width > tolerance) {
    fit(function, from, width / 2, tolerance, depth + 1);
    fit(function, from + width / 2, width / 2, tolerance, depth + 1);
    return;
  }
  Panel panel{from, width, {}};
  a[0] *= 2;
  for (std::size_t k = 1; k <= kDegree; ++k) {
    panel.c[k] = (a[k - 1] - a[k + 1]) / (2.0 * double(k)) * width / 2;
    panel.c[0] += k % 2 ? panel.c[k] : -panel.c[k];  // zero at y = -1
  }
  panels_.push_back(panel);
  sums_.push_back(sums_.back() + std::accumulate(panel.c.begin(), panel.c.end(), 0.0));
}

double PeriodicIntegral::operator()(double x) const {
  const double periods = std::round(x / (2 * kPi));
  const double rest = std::clamp(x - 2 * kPi * periods, -kPi, kPi), size = std::abs(rest);
  const auto after = std::ranges::upper_bound(panels_, size, {}, &Panel::from);
  const std::size_t index = std::size_t(after - panels_.begin()) - 1;
  const Panel& panel = panels_[index];
  const double y = 2 * (size - panel.from) / panel.width - 1;
  double b1 = 0, b2 = 0;  // Clenshaw's sums
  for (std::size_t k = kDegree; k > 0; --k) {
    const double b0 = 2 * y * b1 - b2 + panel.c[k];
    b2 = b1;
    b1 = b0;
  }
  const double part = y * b1 - b2 + panel.c[0];
  return 2 * periods * sums_.back() + std::copysign(sums_[index] + part, rest);
}

Spine::Spine(const Curve& curve)
    : curve_(curve),
      speed_([curve](double psi) { return speed_at_meridian(curve, psi); }),
      slowness_([curve](double psi) { return 1 / speed_at_meridian(curve, psi); }) {
  speed_start_ = speed_(curve_.meridian);
  slowness_start_ = slowness_(curve_.meridian);
  length_ = arc_length(2 * kPi);
  const double turn = least_twist(2 * kPi);
  holonomy_ = std::remainder(turn, 2 * kPi);
  turns_ = int(std::lround((turn - holonomy_) / (2 * kPi)));
}

double Spine::integral_of(const PeriodicIntegral& integral, double start, double t) const {
  return (integral(curve_.q * t + curve_.meridian) - start) / curve_.q;
}

double Spine::arc_length(double t) const {
  return curve_.q == 0 ? t * speed(curve_, 0) : integral_of(speed_, speed_start_, t);
}

double Spine::least_twist(double t) const {
  if (curve_.q == 0) return 0;
  return curve_.p * curve_.q * curve_.ring_radius * integral_of(slowness_, slowness_start_, t);
}

Frame Spine::frame(double t) const {
  const CurvePoint point = curve_point(curve_, t);
  const Vec3d tangent = normalize(point.first), normal = torus_normal(curve_, t);
  const Vec3d side = cross(tangent, normal);
  const double alpha = least_twist(t) - holonomy_ * (arc_length(t) / length_);
  const double c = std::cos(alpha), s = std::sin(alpha);
  const Vec3d across = normal * c + side * s;
  return {point.position, tangent, across, cross(across, tangent)};
}

}  // namespace lumaknot
