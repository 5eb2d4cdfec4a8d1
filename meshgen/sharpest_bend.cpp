// The curvature depends only on the meridian angle psi and is even in it: its square is a ratio of
// polynomials of degrees 4 and 6 in cos psi. So it has at most five stationary values within (0,
// pi), and samples as dense as its features find the maximum.

#include "meshgen/sharpest_bend.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "math/angle.h"

namespace lumaknot {
namespace {

/// Angles from 0 to pi, ascending: evenly spaced ones, and ones between which the curve's direction
/// on the torus turns evenly. It turns quickly where a steep curve (|p| >> |q|) passes near the
/// axis.
std::vector<double> meridian_samples(const Curve& curve) {
  constexpr int kSteps = 256;
  const double ring = curve.major_radius, winding = curve.minor_radius;
  const double steepness = std::abs(double(curve.p) / curve.q) / winding;
  const double lowest = std::atan((ring - winding) * steepness);
  const double highest = std::atan((ring + winding) * steepness);
  std::vector<double> samples;
  for (int i = 0; i <= kSteps; ++i) {
    samples.push_back(kPi * i / kSteps);
    const double direction = lowest + (highest - lowest) * i / kSteps;
    const double reach = steepness > 0 ? std::tan(direction) / steepness : ring;
    samples.push_back(std::acos(std::clamp((reach - ring) / winding, -1.0, 1.0)));
  }
  std::ranges::sort(samples);
  return samples;
}

}  // namespace

Bend sharpest_bend(const Curve& curve) {
  // Lengths near one neither overflow nor underflow in products.
  const double size = curve.major_radius + curve.minor_radius;
  const Curve unit{curve.p,
                   curve.q,
                   curve.major_radius / size,
                   curve.minor_radius / size,
                   0,
                   curve.q == 0 ? curve.meridian : 0};
  const auto bend = [&](double psi) {
    return curvature(curve_point(unit, curve.q == 0 ? 0 : psi / curve.q));
  };
  if (curve.q == 0) return {bend(0) / size, 0};

  const std::vector<double> samples = meridian_samples(unit);
  double max = 0, where = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double left = samples[i > 0 ? i - 1 : 0];
    const double right = samples[std::min(i + 1, samples.size() - 1)];
    if (bend(samples[i]) < std::max(bend(left), bend(right))) continue;
    // Half of a double's bits: a flat maximum can't be located more precisely.
    const auto [psi, value] = boost::math::tools::brent_find_minima(
        [&](double x) { return -bend(x); }, left, right, std::numeric_limits<double>::digits / 2);
    for (const double candidate : {samples[i], psi}) {
      if (bend(candidate) > max) max = bend(where = candidate);
    }
  }
  const double t = std::fmod((where - curve.meridian) / curve.q, 2 * kPi);
  return {max / size, t < 0 ? t + 2 * kPi : t};
}

}  // namespace lumaknot
