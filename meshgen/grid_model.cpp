#include "meshgen/grid_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/angle.h"
#include "meshgen/tube_distance.h"

namespace lumaknot {
namespace {

/// -X_tt . n = s^2 (K (1 + r K) + r w^2) on the outer side of the bend, where it is largest; s is
/// the speed, K the curvature and w the frame's rotation per unit length.
double bulge(const TubeSurface& surface, double t) {
  const CurvePoint point = curve_point(surface.spine().curve(), t);
  const double k = curvature(point), r = surface.tube_radius();
  const double turn = surface.spine().holonomy() / surface.spine().length();
  return dot(point.first, point.first) * (k * (1 + r * k) + r * turn * turn);
}

/// The local peaks of the bulge on one period of the meridian angle, each repeated on all periods.
std::vector<Peak> peaks_of(const TubeSurface& surface) {
  const Curve& curve = surface.spine().curve();
  const int periods = std::max(1, std::abs(curve.q)), samples = 720;
  const double step = 2 * kPi / periods / samples;
  const double start = curve.q == 0 ? 0 : -curve.meridian / curve.q;
  std::vector<Peak> peaks;
  for (int i = 0; i < samples; ++i) {
    const double t = start + step * i, here = bulge(surface, t);
    if (here < bulge(surface, t - step) || here < bulge(surface, t + step)) continue;
    for (int k = 0; k < periods; ++k) peaks.push_back({t + 2 * kPi * k / periods, here});
    if (curve.p == 0 || curve.q == 0) return peaks;  // a circle is the same everywhere
  }
  std::ranges::stable_sort(peaks, std::ranges::greater{}, &Peak::bulge);
  return peaks;
}

/// The largest curvature, to a few units in 1e5.
double sharpest_of(const Curve& curve) {
  double sharpest = 0;
  for (int i = 0; i < 720; ++i) {
    const double psi = 2 * kPi * i / 720;
    const double t = curve.q == 0 ? 0 : (psi - curve.meridian) / curve.q;
    sharpest = std::max(sharpest, curvature(curve_point(curve, t)));
  }
  return sharpest;
}

/// The outer side of the bend at t.
Witness witness_at(const TubeSurface& surface, double t) {
  const RingFrame frame = surface.spine().frame(t);
  const Vec3d bend = curve_point(surface.spine().curve(), t).second;
  return {t, std::atan2(-dot(bend, frame.binormal), -dot(bend, frame.normal))};
}

}  // namespace

GridModel grid_model(const TubeSurface& surface) {
  const std::vector<Peak> peaks = peaks_of(surface);
  const Spine& spine = surface.spine();
  const CurvePoint top = curve_point(spine.curve(), peaks.front().t);
  const double rate = length(top.first);
  GridModel model{surface,
                  peaks.front(),
                  rate * curvature(top),
                  surface.tube_radius() * rate * spine.holonomy() / spine.length(),
                  sharpest_of(spine.curve()),
                  {}};
  for (const Peak& peak : peaks) {
    if (peak.bulge < 0.9 * model.peak.bulge) break;
    model.witnesses.push_back(witness_at(surface, peak.t));
  }
  return model;
}

double ring_error(const GridModel& model, int sides) {
  const double s = std::sin(kPi / sides / 2);
  return 2 * model.surface.tube_radius() * s * s;
}

int min_sides(const GridModel& model, double max_error) {
  const double r = model.surface.tube_radius();
  if (max_error >= r) return 3;
  int sides = std::max(3, int(kPi / std::acos(1 - max_error / r)) - 1);
  while (ring_error(model, sides) > max_error) ++sides;
  return sides;
}

namespace {

/// The error at the peak to second order. The quadratic form that measures it gives a triangle of
/// squared edges a (along), b (around), d (across the quad); the error is half the squared radius
/// of its smallest enclosing circle.
double model_error(const GridModel& model, int segments, int sides) {
  const double h = 2 * kPi / segments, k = 2 * kPi / sides;
  const double a = h * h * model.peak.bulge, b = 8 * ring_error(model, sides);
  const double c = h * k * model.twist, d = a + b + 2 * c;
  const bool acute = c < 0 && d + a > b && d + b > a;
  return (acute ? a * b * d / (a * b - c * c) : std::max({a, b, d})) / 8;
}

/// The share of the model's error that may be missing: the loss when the peak falls between two
/// segments or sides, times four since not only the bulge changes there, the next order, and 2 %.
double doubt(const GridModel& model, int segments, int sides) {
  double min = model.peak.bulge;
  for (const double side : {-1, 1}) {
    min = std::min(min, bulge(model.surface, model.peak.t + side * kPi / segments));
  }
  const double phase = 2 - min / model.peak.bulge - std::cos(kPi / sides);
  const double turned = 2 * kPi / segments * model.turning;
  return 0.02 + 4 * phase + turned * turned / 10;
}

}  // namespace

int min_segments(const GridModel& model, int sides, double max_error, int max) {
  const auto fails = [&](int n) {
    return model_error(model, n, sides) * (1 - doubt(model, n, sides)) > max_error;
  };
  const double room = max_error - ring_error(model, sides);
  const double ideal = room > 0 ? kPi * std::sqrt(model.peak.bulge / 2 / room) : max;
  int n = int(std::clamp(ideal, 3.0, double(max)));
  while (n < max && fails(n)) n += 1 + n / 512;
  while (n > 3 && !fails(n - 1)) n = std::max(3, n - 1 - n / 512);
  return n;
}

namespace {

/// The error of some edge along the tube, for n segments and any number of sides from kManySides
/// on: per segment, the edges within half a side of the outer side of its bend.
double edge_error(const GridModel& model, int n) {
  const TubeSurface& surface = model.surface;
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    const double a = ring_parameter(i, n), b = ring_parameter(i + 1, n), t = a + (b - a) / 2;
    const CurvePoint centre = curve_point(surface.spine().curve(), t);
    const double outer = witness_at(surface, t).theta;
    double min = std::numeric_limits<double>::infinity();
    for (const double side : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
      const double theta = outer + side * 2 * kPi / kManySides;
      const Vec3d x = (surface.at(a, theta).position + surface.at(b, theta).position) * 0.5;
      const double d = distance_near(surface.spine().curve(), centre, t, x);
      min = std::min(min, std::abs(d - surface.tube_radius()));
    }
    worst = std::max(worst, min);
  }
  return worst;
}

}  // namespace

int min_segments_of_many_sides(const GridModel& model, double max_error) {
  int n = 3;
  while (n < 128 && edge_error(model, n) > max_error) ++n;
  return n;
}

}  // namespace lumaknot
