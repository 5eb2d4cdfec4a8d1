#include "study/plan/neighborhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "math/angle.h"
#include "math/number.h"

namespace lumaknot::plan {
namespace {

std::array<double, 4> channels(const exact::Sample& s) {
  return {s.color.x, s.color.y, s.color.z, s.coverage};
}

exact::Sample from_channels(const std::array<double, 4>& c) { return {{c[0], c[1], c[2]}, c[3]}; }

Vec2d moved(double x, double y, double radius, double angle) {
  return {x + radius * std::cos(angle), y + radius * std::sin(angle)};
}

}  // namespace

SeenPlace place_of(const exact::ExactFragment& seen) {
  return seen.fragment.covered() ? SeenPlace{seen.fragment.triangle, seen.t, seen.theta}
                                 : SeenPlace{};
}

bool on_one_piece(const SeenPlace& a, const SeenPlace& b) {
  if (a.component != b.component) return false;
  const auto apart = [](double d) { return std::min(std::abs(d), kTurn - std::abs(d)); };
  return apart(a.t - b.t) < 0.2 && apart(a.theta - b.theta) < 0.8;
}

void SampleRange::add(const exact::Sample& sample, double error) {
  std::array<double, 4> min = channels(low), max = channels(high);
  const std::array<double, 4> value = channels({saturate(sample.color), sample.coverage});
  for (std::size_t c = 0; c < 4; ++c) {
    min[c] = std::min(min[c], value[c] + error);
    max[c] = std::max(max[c], value[c] - error);
  }
  low = from_channels(min);
  high = from_channels(max);
}

double SampleRange::distance(const exact::Sample& sample) const {
  const std::array<double, 4> min = channels(low), max = channels(high);
  const std::array<double, 4> value = channels({saturate(sample.color), sample.coverage});
  double worst = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!std::isfinite(value[c])) return std::numeric_limits<double>::infinity();
    worst = std::max({worst, min[c] - value[c], value[c] - max[c]});
  }
  return worst;
}

void PixelNeighborhood::look_coarsely(NeighborhoodRange& neighborhood, int x, int y) const {
  if (neighborhood.has_coarse) return;
  neighborhood.has_coarse = true;
  neighborhood.coarse = neighborhood.place;
  if (area_ && shift_ > 0) look_at_cells(neighborhood.coarse, x, y, 8);
}

void PixelNeighborhood::look_quickly(NeighborhoodRange& neighborhood, int x, int y) const {
  if (neighborhood.has_quick) return;
  look_coarsely(neighborhood, x, y);
  neighborhood.has_quick = true;
  neighborhood.quick = neighborhood.coarse;
  if (shift_ == 0) return;
  if (area_) return look_at_cells(neighborhood.quick, x, y, 16);
  look_around(neighborhood.quick, x + 0.5, y + 0.5);
}

void PixelNeighborhood::look_fully(NeighborhoodRange& neighborhood, int x, int y) const {
  if (neighborhood.has_full) return;
  look_quickly(neighborhood, x, y);
  neighborhood.has_full = true;
  neighborhood.full = neighborhood.behind = neighborhood.quick;
  if (shift_ == 0) return;
  if (area_) {
    look_at_cells(neighborhood.full, x, y, 32);
    neighborhood.behind = neighborhood.full;
  } else {
    look_closely(neighborhood, x + 0.5, y + 0.5);
  }
}

void PixelNeighborhood::look_around(SampleRange& range, double x, double y) const {
  for (int k = 0; k < 16; ++k) {
    const Vec2d at = moved(x, y, k < 8 ? shift_ : shift_ / 2, k * kTurn / 8);
    range.add(pixels_.sample(pixels_.at(at.u, at.v).fragment), 0);
  }
}

void PixelNeighborhood::look_at_cells(SampleRange& range, int x, int y, int cells) const {
  const double side = 1.0 / cells, reach = shift_ - side * std::numbers::sqrt2 / 2;
  if (reach < 0) return;
  const int border = int(reach / side), width = cells + 2 * border;
  std::vector<std::array<double, 4>> seen;  // cell by cell, including those of the border
  for (int k = 0; k < width * width; ++k) {
    const int column = k % width - border, row = k / width - border;
    const double u = x + side * (column + 0.5), v = y + side * (row + 0.5);
    seen.push_back(channels(pixels_.sample(pixels_.at(u, v).fragment)));
  }
  std::vector<std::ptrdiff_t> near;  // steps from a cell to those within reach
  for (int v = -border; v <= border; ++v) {
    for (int u = -border; u <= border; ++u) {
      if (std::hypot(u, v) * side <= reach) near.push_back(std::ptrdiff_t(v) * width + u);
    }
  }
  std::array<double, 4> low{}, high{};
  for (int k = 0; k < cells * cells; ++k) {
    const std::ptrdiff_t row = k / cells + border, own = row * width + k % cells + border;
    std::array<double, 4> min = seen[std::size_t(own)], max = min;
    for (const std::ptrdiff_t step : near) {
      const std::array<double, 4>& other = seen[std::size_t(own + step)];
      for (std::size_t c = 0; c < 4; ++c) {
        min[c] = std::min(min[c], other[c]);
        max[c] = std::max(max[c], other[c]);
      }
    }
    for (std::size_t c = 0; c < 4; ++c) {
      low[c] += min[c] * side * side;
      high[c] += max[c] * side * side;
    }
  }
  range.add(from_channels(low), 0);
  range.add(from_channels(high), 0);
}

void PixelNeighborhood::look_closely(NeighborhoodRange& neighborhood, double x, double y) const {
  constexpr std::size_t kRings = 8, kRays = 32;
  std::array<std::array<Vec2d, kRays>, kRings> places;
  std::array<std::array<exact::ExactFragment, kRays>, kRings> seen;
  const auto look_along = [&](Vec2d at) {
    const exact::ExactFragment found = pixels_.at(at.u, at.v);
    neighborhood.full.add(pixels_.sample(found.fragment), 0);
    look_behind(neighborhood.behind, at, shift_ - std::hypot(at.u - x, at.v - y), found);
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
      if (!on_one_piece(place_of(seen[ring][k]), place_of(seen[ring][next]))) {
        look_at_edge(neighborhood.full, places[ring][k], places[ring][next]);
      }
      if (ring > 0 && !on_one_piece(place_of(seen[ring][k]), place_of(seen[ring - 1][k]))) {
        look_at_edge(neighborhood.full, places[ring][k], places[ring - 1][k]);
      }
    }
  }
}

/// Across a straight tube the line is a chord between normals that turn by twice the angle a: along
/// a normal it is 2 r sin(a)^2 long, and r (1 - cos(a)) deep.
double passage_depth(const Vec3d& through, const Vec3d& normal, double tube_radius) {
  const double sine2 = std::min(std::abs(dot(through, normal)) / (2 * tube_radius), 1.0);
  return tube_radius * (1 - std::sqrt(1 - sine2));
}

/// Through surfaces no deeper than `depth`, in pixels.
void PixelNeighborhood::look_behind(SampleRange& range, Vec2d at, double depth,
                                    const exact::ExactFragment& seen) const {
  constexpr int kMax = 4;  // passages through the tube
  constexpr double kBeyond = 1 + 1e-9;
  exact::ExactFragment in = seen;
  for (int i = 0; i < kMax && in.fragment.covered(); ++i) {
    const exact::ExactFragment out = pixels_.at(at.u, at.v, in.fragment.depth * kBeyond);
    if (!out.fragment.covered()) return;
    const Vec3d through = out.fragment.position - in.fragment.position;
    const double deep = std::max(passage_depth(through, in.fragment.normal, tube_radius_),
                                 passage_depth(through, out.fragment.normal, tube_radius_));
    if (deep > depth * pixels_.pixel_width() * in.fragment.depth) return;
    range.add(pixels_.sample(out.fragment), 0);
    in = pixels_.at(at.u, at.v, out.fragment.depth * kBeyond);
    range.add(pixels_.sample(in.fragment), 0);
  }
}

/// Towards its limb a surface's colour changes faster and faster: both sides of the edge.
void PixelNeighborhood::look_at_edge(SampleRange& range, Vec2d a, Vec2d b) const {
  constexpr int kHalvings = 24;
  exact::ExactFragment at_a = pixels_.at(a.u, a.v), at_b = pixels_.at(b.u, b.v);
  for (int i = 0; i < kHalvings; ++i) {
    const Vec2d middle{(a.u + b.u) / 2, (a.v + b.v) / 2};
    const exact::ExactFragment at = pixels_.at(middle.u, middle.v);
    const bool with_a = on_one_piece(place_of(at), place_of(at_a));
    (with_a ? a : b) = middle;
    (with_a ? at_a : at_b) = at;
  }
  range.add(pixels_.sample(at_a.fragment), 0);
  range.add(pixels_.sample(at_b.fragment), 0);
}

}  // namespace lumaknot::plan
