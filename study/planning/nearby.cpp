#include "study/planning/nearby.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "shaders/number.h"

namespace lumaknot {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kCoarse = 1.0 / 64;  // of means that are looked at first

/// Opposite directions follow each other: two of them hold most pixels at an edge.
constexpr std::array<int, 8> kDirections{0, 4, 2, 6, 1, 5, 3, 7};

std::array<double, 4> channels(const Sample& s) {
  return {s.color.x, s.color.y, s.color.z, s.coverage};
}

Sample from_channels(const std::array<double, 4>& c) { return {{c[0], c[1], c[2]}, c[3]}; }

Vec2d moved(double x, double y, double radius, double angle) {
  return {x + radius * std::cos(angle), y + radius * std::sin(angle)};
}

/// Whether both show one smooth piece of the surface.
bool continuous(const ExactFragment& a, const ExactFragment& b) {
  if (a.fragment.triangle != b.fragment.triangle) return false;
  if (!a.fragment.covered()) return true;
  const auto apart = [](double d) { return std::min(std::abs(d), kTurn - std::abs(d)); };
  return apart(a.t - b.t) < 0.2 && apart(a.theta - b.theta) < 0.8;
}

}  // namespace

void SampleRange::add(const Sample& sample, double error) {
  std::array<double, 4> least = channels(low), most = channels(high);
  const std::array<double, 4> value = channels({saturate(sample.color), sample.coverage});
  for (std::size_t c = 0; c < 4; ++c) {
    least[c] = std::min(least[c], value[c] + error);
    most[c] = std::max(most[c], value[c] - error);
  }
  low = from_channels(least);
  high = from_channels(most);
}

double SampleRange::distance(const Sample& sample) const {
  const std::array<double, 4> least = channels(low), most = channels(high);
  const std::array<double, 4> value = channels({saturate(sample.color), sample.coverage});
  double worst = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!std::isfinite(value[c])) return std::numeric_limits<double>::infinity();
    worst = std::max({worst, least[c] - value[c], value[c] - most[c]});
  }
  return worst;
}

void Nearby::widen(NearbyRange& nearby, int x, int y) const {
  const int step = nearby.looked++;
  if (!area_ && step == 16) return look_closely(nearby, x + 0.5, y + 0.5);
  const double radius = step % 16 < 8 ? shift_ : shift_ / 2;
  const Vec2d at = moved(x, y, radius, kDirections[std::size_t(step % 8)] * kTurn / 8);
  look(nearby.range, at.u, at.v, step < 16 ? std::max(kCoarse, fine_) : fine_);
}

/// At the pixel whose top left corner is (x, y).
void Nearby::look(SampleRange& range, double x, double y, double error) const {
  if (!area_) return range.add(pixels_.sample(pixels_.at(x + 0.5, y + 0.5).fragment), 0);
  const PixelTruth mean = area_square(pixels_, x, y, error);
  range.add(mean.sample, mean.error);
}

void Nearby::look_closely(NearbyRange& nearby, double x, double y) const {
  constexpr std::size_t kRings = 4, kRays = 16;
  std::array<std::array<Vec2d, kRays>, kRings> places;
  std::array<std::array<ExactFragment, kRays>, kRings> seen;
  const auto look_along = [&](Vec2d at) {
    const ExactFragment found = pixels_.at(at.u, at.v);
    nearby.range.add(pixels_.sample(found.fragment), 0);
    look_behind(nearby.behind, at, found);
    return found;
  };
  look_along({x, y});
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    for (std::size_t k = 0; k < kRays; ++k) {
      places[ring][k] = moved(x, y, shift_ * double(ring + 1) / kRings, double(k) * kTurn / kRays);
      seen[ring][k] = look_along(places[ring][k]);
    }
  }
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    for (std::size_t k = 0; k < kRays; ++k) {
      const std::size_t next = (k + 1) % kRays;
      if (!continuous(seen[ring][k], seen[ring][next])) {
        look_at_edge(nearby.range, places[ring][k], places[ring][next]);
      }
      if (ring > 0 && !continuous(seen[ring][k], seen[ring - 1][k])) {
        look_at_edge(nearby.range, places[ring][k], places[ring - 1][k]);
      }
    }
  }
}

/// Through what is no deeper than the shift.
void Nearby::look_behind(SampleRange& range, Vec2d at, const ExactFragment& seen) const {
  constexpr int kMost = 4;  // passages through the tube
  constexpr double kBeyond = 1 + 1e-9;
  ExactFragment in = seen;
  for (int i = 0; i < kMost && in.fragment.covered(); ++i) {
    const ExactFragment out = pixels_.at(at.u, at.v, in.fragment.depth * kBeyond);
    if (!out.fragment.covered()) return;
    const Vec3d through = out.fragment.position - in.fragment.position;
    // Of an arc the height is a quarter of its chord times the sine at its ends.
    const double depth = std::abs(dot(through, in.fragment.normal)) / 4;
    if (depth > shift_ * pixels_.pixel_width() * in.fragment.depth) return;
    range.add(pixels_.sample(out.fragment), 0);
    in = pixels_.at(at.u, at.v, out.fragment.depth * kBeyond);
    range.add(pixels_.sample(in.fragment), 0);
  }
}

/// Towards its limb a surface's colour changes faster and faster: both sides of the edge.
void Nearby::look_at_edge(SampleRange& range, Vec2d a, Vec2d b) const {
  constexpr int kHalvings = 24;
  ExactFragment at_a = pixels_.at(a.u, a.v), at_b = pixels_.at(b.u, b.v);
  for (int i = 0; i < kHalvings; ++i) {
    const Vec2d middle{(a.u + b.u) / 2, (a.v + b.v) / 2};
    const ExactFragment at = pixels_.at(middle.u, middle.v);
    const bool with_a = continuous(at, at_a);
    (with_a ? a : b) = middle;
    (with_a ? at_a : at_b) = at;
  }
  range.add(pixels_.sample(at_a.fragment), 0);
  range.add(pixels_.sample(at_b.fragment), 0);
}

}  // namespace lumaknot
