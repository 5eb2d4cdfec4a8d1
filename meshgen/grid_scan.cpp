#include "meshgen/grid_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "math/angle.h"
#include "meshgen/tube_distance.h"

namespace lumaknot {
namespace {

/// At the sides j + fraction.
std::vector<SinCos> between_sides(int sides, double fraction) {
  std::vector<SinCos> all;
  all.reserve(std::size_t(sides));
  for (int j = 0; j < sides; ++j) all.push_back(sin_cos(2 * kPi * (j + fraction) / sides));
  return all;
}

/// The side's direction, from the table if present.
SinCos side_direction(const TubeGrid& grid, int side) {
  if (!grid.whole.empty()) return grid.whole[std::size_t(side % grid.sides)];
  return sin_cos(ring_parameter(side % grid.sides, grid.sides));
}

Vec3d normal_at(const RingFrame& frame, const SinCos& d) {
  return frame.normal * d.c + frame.binormal * d.s;
}

/// The deviation of points from a centre line with a known point at t.
struct Offset {
  const TubeSurface& surface;
  double t;
  CurvePoint centre;
  double operator()(const Vec3d& x) const {
    return distance_near(surface.spine().curve(), centre, t, x) - surface.tube_radius();
  }
};

Offset offset_at(const TubeGrid& grid, double segment) {
  const double t = 2 * kPi * segment / grid.segments;
  return {grid.surface, t, curve_point(grid.surface.spine().curve(), t)};
}

Vec3d middle(const Vec3d& a, const Vec3d& b) { return (a + b) * 0.5; }

/// A place in a triangle, as in Site, and the expected offset there.
struct Spot {
  double u, v, value;
};

/// The stationary point, if inside, of the quadratic f0 + g (u, v) + (u, v) H (u, v) / 2 through
/// the six offsets.
std::optional<Spot> stationary(const TriangleOffsets& f) {
  const double gu = 4 * f.edge01 - 3 * f.corner[0] - f.corner[1];
  const double gv = 4 * f.edge02 - 3 * f.corner[0] - f.corner[2];
  const double huu = 4 * (f.corner[0] + f.corner[1] - 2 * f.edge01);
  const double hvv = 4 * (f.corner[0] + f.corner[2] - 2 * f.edge02);
  const double huv = 4 * (f.corner[0] + f.edge12 - f.edge01 - f.edge02);
  const double determinant = huu * hvv - huv * huv;
  if (determinant == 0) return {};
  const double u = (huv * gv - hvv * gu) / determinant, v = (huv * gu - huu * gv) / determinant;
  if (!(u > 0 && v > 0 && u + v < 1)) return {};
  return Spot{u, v, f.corner[0] + (gu * u + gv * v) / 2};
}

bool goes_before(const Finding& a, const Finding& b) {
  return std::tuple(-a.value, a.site.segment, a.site.side, a.site.second, a.site.u, a.site.v) <
         std::tuple(-b.value, b.site.segment, b.site.side, b.site.second, b.site.u, b.site.v);
}

}  // namespace

TubeGrid tube_grid(const TubeSurface& surface, int segments, int sides,
                   std::span<const Vec3d> positions, std::span<const Vec3d> normals) {
  return {surface,
          segments,
          sides,
          positions,
          normals,
          sin_cos_table(sides),
          between_sides(sides, 1.0 / 3),
          between_sides(sides, 0.5),
          between_sides(sides, 2.0 / 3)};
}

void WorstFindings::offer(double value, const Site& site) {
  if (!(value > threshold())) return;
  const Finding finding{value, site};
  list_.insert(std::ranges::upper_bound(list_, finding, goes_before), finding);
  if (list_.size() > kKept) list_.pop_back();
}

void WorstFindings::merge(const WorstFindings& other) {
  std::vector<Finding> both;
  std::ranges::merge(list_, other.list_, std::back_inserter(both), goes_before);
  both.resize(std::min(both.size(), kKept));
  list_ = std::move(both);
}

GridRow grid_row(const TubeGrid& grid, int segment, int side, int count) {
  const Offset off = offset_at(grid, segment);
  GridRow row{segment, side, grid.surface.spine().frame(off.t), {}, {}, {}, {}};
  for (int k = 0; k <= count; ++k) {
    const int j = side + k;
    if (grid.positions.empty()) {
      row.normals.push_back(normal_at(row.frame, side_direction(grid, j)));
      row.positions.push_back(row.frame.position + row.normals.back() * grid.surface.tube_radius());
    } else {
      const std::size_t vertex =
          std::size_t(segment) * std::size_t(grid.sides + 1) + std::size_t(j);
      row.normals.push_back(grid.normals[vertex]);
      row.positions.push_back(grid.positions[vertex]);
    }
    row.vertex.push_back(off(row.positions.back()));
    if (k > 0)
      row.edge.push_back(off(middle(row.positions[std::size_t(k - 1)], row.positions.back())));
  }
  return row;
}

void GridScan::strip(const TubeGrid& grid, const GridRow& low, const GridRow& high) {
  const Offset off = offset_at(grid, low.segment + 0.5);
  const std::vector<Vec3d>&a = low.positions, &b = high.positions;
  double along = off(middle(a[0], b[0]));
  for (std::size_t j = 0; j + 1 < a.size(); ++j) {
    const double next = off(middle(a[j + 1], b[j + 1])), diagonal = off(middle(a[j], b[j + 1]));
    const Site site{low.segment, low.side + int(j)};
    triangle(grid, site, {a[j], b[j], b[j + 1]},
             {{low.vertex[j], high.vertex[j], high.vertex[j + 1]}, along, high.edge[j], diagonal});
    triangle(grid, {site.segment, site.side, true}, {a[j], b[j + 1], a[j + 1]},
             {{low.vertex[j], high.vertex[j + 1], low.vertex[j + 1]}, diagonal, next, low.edge[j]});
    along = next;
  }
  if (with_normals_) normals_of(grid, low, high);
}

void GridScan::triangle(const TubeGrid& grid, Site site, const std::array<Vec3d, 3>& corners,
                        const TriangleOffsets& f) {
  const auto offer = [&](double value, double u, double v) {
    if (std::abs(value) <= chords_.threshold()) return;
    site.u = u;
    site.v = v;
    chords_.offer(std::abs(value), site);
  };
  offer(f.corner[0], 0, 0);
  offer(f.corner[1], 1, 0);
  offer(f.corner[2], 0, 1);
  offer(f.edge01, 0.5, 0);
  offer(f.edge12, 0.5, 0.5);
  offer(f.edge02, 0, 0.5);
  const std::optional<Spot> spot = stationary(f);
  constexpr double kDoubt = 1.5;  // how wrong the prediction may be
  if (!spot || std::abs(spot->value) * kDoubt <= chords_.threshold()) return;
  const auto [u, v, predicted] = *spot;
  const Site inside{site.segment, site.side, site.second, u, v};
  const Offset off = offset_at(grid, site.segment + segment_fraction(inside));
  offer(off(corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v), u, v);
}

void GridScan::normals_of(const TubeGrid& grid, const GridRow& low, const GridRow& high) {
  const Spine& spine = grid.surface.spine();
  const auto frame = [&](double f) {
    return spine.frame(2 * kPi * (low.segment + f) / grid.segments);
  };
  const RingFrame third = frame(1.0 / 3), half = frame(0.5), rest = frame(2.0 / 3);
  const std::vector<Vec3d>&a = low.normals, &b = high.normals;
  for (std::size_t k = 0; k + 1 < a.size(); ++k) {
    const int side = low.side + int(k);
    const std::size_t j = std::size_t(side % grid.sides);
    const auto offer = [&](const Vec3d& sum, const Vec3d& exact, bool second, double u, double v) {
      const double value = angle_key(sum, exact);
      if (value > normals_.threshold()) normals_.offer(value, {low.segment, side, second, u, v});
    };
    const Vec3d diagonal = a[k] + b[k + 1];
    offer(a[k], normal_at(low.frame, grid.whole[j]), false, 0, 0);
    offer(a[k] + a[k + 1], normal_at(low.frame, grid.half[j]), true, 0, 0.5);
    offer(a[k] + b[k], normal_at(half, grid.whole[j]), false, 0.5, 0);
    offer(diagonal, normal_at(half, grid.half[j]), false, 0, 0.5);
    offer(diagonal + b[k], normal_at(rest, grid.third[j]), false, 1.0 / 3, 1.0 / 3);
    offer(diagonal + a[k + 1], normal_at(third, grid.rest[j]), true, 1.0 / 3, 1.0 / 3);
  }
}

void GridScan::merge(const GridScan& other) {
  chords_.merge(other.chords_);
  normals_.merge(other.normals_);
}

double angle_key(const Vec3d& a, const Vec3d& b) {
  const Vec3d c = cross(a, b);
  const double square = dot(a, a), sine = square > 0 ? dot(c, c) / square : 1;
  return dot(a, b) < 0 ? 2 - sine : sine;
}

double angle_key_degrees(double key) {
  const double acute = std::asin(std::sqrt(std::min(std::min(key, 2 - key), 1.0)));
  return (key > 1 ? kPi - acute : acute) * 180 / kPi;
}

double segment_fraction(const Site& site) { return site.second ? site.u : site.u + site.v; }

double side_fraction(const Site& site) { return site.second ? site.u + site.v : site.v; }

}  // namespace lumaknot
