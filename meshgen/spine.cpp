#include "meshgen/spine.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/angle.h"

namespace lumaknot {
namespace {

/// |C'| as a function of the meridian angle.
double speed_at_meridian(const Curve& curve, double psi) {
  const double reach = curve.major_radius + curve.minor_radius * std::cos(psi);
  const double around = curve.minor_radius * curve.q, along = reach * curve.p;
  return std::sqrt(around * around + along * along);  // hypot() costs twice as much
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
  constexpr int kPanels = 8;  // enough for most knots
  for (int k = 0; k < kPanels; ++k) {
    fit(function, kPi * k / kPanels, kPi / kPanels, 4e-15 * kPi * sum / kDegree, 0);
  }
}

// The series a_k of the function, k < kDegree, from its values at the Chebyshev points; that of its
// integral has c_k = (a_(k-1) - a_(k+1)) / (2 k) times half the width.
void PeriodicIntegral::fit(const std::function<double(double)>& function, double from, double width,
                           double tolerance, int depth) {
  constexpr int kDeepest = 17;  // a panel of 3e-6 radians
  static const auto kCosines = chebyshev_cosines<kDegree>();
  std::array<double, kDegree + 2> a{};
  for (const auto& cosines : kCosines) {
    const double value = function(from + width * (cosines[1] + 1) / 2);
    for (std::size_t k = 0; k < kDegree; ++k) {
      a[k] += value * cosines[k];
    }
  }
  a[0] /= 2;
  for (double& each : a) each *= 2.0 / kDegree;
  const double tail = std::abs(a[kDegree - 1]) + std::abs(a[kDegree - 2]);
  // Relative to the whole integral, not the panel's: a steep function's own rounding stays below
  // it. The integral also divides these by 2 k, which leaves 1e-16 of it.
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

double PeriodicIntegral::within(std::size_t index, double x) const {
  const Panel& panel = panels_[index];
  const double y = 2 * (x - panel.from) / panel.width - 1;
  double b1 = 0, b2 = 0;  // Clenshaw's sums
  for (std::size_t k = kDegree; k > 0; --k) {
    const double b0 = 2 * y * b1 + (panel.c[k] - b2);  // b2 is ready before b1
    b2 = b1;
    b1 = b0;
  }
  return sums_[index] + (y * b1 - b2 + panel.c[0]);
}

double PeriodicIntegral::operator()(double x) const {
  const double periods = std::round(x / (2 * kPi));
  const double rest = std::clamp(x - 2 * kPi * periods, -kPi, kPi), size = std::abs(rest);
  const auto after = std::ranges::upper_bound(panels_, size, {}, &Panel::from);
  const double part = within(std::size_t(after - panels_.begin()) - 1, size);
  return 2 * periods * sums_.back() + std::copysign(part, rest);
}

std::vector<double> PeriodicIntegral::table(int n) const {
  std::vector<double> values(std::size_t(n) + 1);
  std::size_t panel = 0;
  for (int k = 0; 2 * k <= n; ++k) {
    const double x = std::min(ring_parameter(k, n), kPi);
    while (panel + 1 < panels_.size() && panels_[panel + 1].from <= x) ++panel;
    values[std::size_t(k)] = within(panel, x);
    values[std::size_t(n - k)] = 2 * sums_.back() - values[std::size_t(k)];  // even function
  }
  values.front() = 0;  // to the bit; a series would leave rounding
  values.back() = 2 * sums_.back();
  return values;
}

Spine::Spine(const Curve& curve)
    : curve_(curve),
      speed_([curve](double psi) { return speed_at_meridian(curve, psi); }),
      slowness_([curve](double psi) { return 1 / speed_at_meridian(curve, psi); }) {
  speed_start_ = speed_(curve_.meridian);
  slowness_start_ = slowness_(curve_.meridian);
  length_ = arc_length(2 * kPi);
  holonomy_ = std::remainder(min_twist(2 * kPi), 2 * kPi);
}

double Spine::integral_of(const PeriodicIntegral& integral, double start, double t) const {
  return (integral(curve_.q * t + curve_.meridian) - start) / curve_.q;
}

double Spine::arc_length(double t) const {
  return curve_.q == 0 ? t * speed(curve_, 0) : integral_of(speed_, speed_start_, t);
}

double Spine::min_twist(double t) const {
  if (curve_.q == 0) return 0;
  return twist_rate() * integral_of(slowness_, slowness_start_, t);
}

RingFrame Spine::frame_at(const TorusAngles& at, double twist, double arc_length) const {
  const auto& [longitude, meridian] = at;
  const CurvePoint point = curve_point(curve_, at);
  const Vec3d tangent = normalize(point.first);
  const Vec3d torus_normal{meridian.c * longitude.c, meridian.c * longitude.s,
                           meridian.s};  // the torus's
  const SinCos turn = sin_cos(twist - holonomy_ * (arc_length / length_));
  const Vec3d normal = torus_normal * turn.c + cross(tangent, torus_normal) * turn.s;
  return {point.position, tangent, normal, cross(normal, tangent)};
}

RingFrame Spine::frame(double t) const {
  return frame_at(torus_angles(curve_, t), min_twist(t), arc_length(t));
}

// A ring's meridian is a whole number of n-ths of a turn, whatever q; the phase is zero unless q is
// zero, and then nothing is integrated.
std::vector<double> Spine::at_rings(const PeriodicIntegral& integral, int n) const {
  const std::vector<double> table = integral.table(n);
  std::vector<double> values;
  values.reserve(table.size());
  Winding meridian(curve_.q, n);
  for (int i = 0; i <= n; ++i) {
    values.push_back((meridian.revolutions() * table.back() + table[meridian.part()]) / curve_.q);
    meridian.advance();
  }
  return values;
}

std::vector<double> Spine::arc_lengths(int n) const {
  if (curve_.q != 0) return at_rings(speed_, n);
  std::vector<double> lengths;
  for (int i = 0; i <= n; ++i) lengths.push_back(arc_length(ring_parameter(i, n)));
  return lengths;
}

std::vector<RingFrame> Spine::frames(std::span<const double> arc_lengths) const {
  const int n = int(arc_lengths.size()) - 1;
  const std::vector<TorusAngles> angles = ring_angles(curve_, n);
  const std::vector<double> slowness =
      curve_.q != 0 ? at_rings(slowness_, n) : std::vector<double>(arc_lengths.size());
  std::vector<RingFrame> frames;
  frames.reserve(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    frames.push_back(frame_at(angles[i], twist_rate() * slowness[i], arc_lengths[i]));
  }
  return frames;
}

}  // namespace lumaknot
