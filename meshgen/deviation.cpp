#include "meshgen/deviation.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>

#include "math/angle.h"
#include "meshgen/grid_scan.h"
#include "meshgen/tube_distance.h"
#include "system/error.h"

namespace lumaknot {
namespace {

using Strips = oneapi::tbb::blocked_range<int>;

/// All strips, in blocks that depend only on the grid.
GridScan scan_all(const TubeGrid& grid, bool with_normals) {
  const auto block = [&](const Strips& strips, GridScan scan) {
    GridRow low = grid_row(grid, strips.begin(), 0, grid.sides);
    for (int i = strips.begin(); i < strips.end(); ++i) {
      GridRow high = grid_row(grid, i + 1, 0, grid.sides);
      scan.strip(grid, low, high);
      low = std::move(high);
    }
    return scan;
  };
  const auto join = [](GridScan a, const GridScan& b) {
    a.merge(b);
    return a;
  };
  const std::size_t grain = std::size_t(std::max(16, 4096 / grid.sides));
  // A circle's strips are all equal and would fill the list of the worst with copies of one
  // triangle.
  const Curve& curve = grid.surface.spine().curve();
  const bool alike = grid.positions.empty() && (curve.p == 0 || curve.q == 0);
  const int strips = alike ? 1 : grid.segments;
  return oneapi::tbb::parallel_deterministic_reduce(Strips(0, strips, grain),
                                                    GridScan(with_normals), block, join);
}

/// The corners of a site's triangle.
struct Corners {
  Vec3d positions[3], normals[3];
};

Corners corners_of(const TubeGrid& grid, const Site& site) {
  const GridRow a = grid_row(grid, site.segment, site.side, 1);
  const GridRow b = grid_row(grid, site.segment + 1, site.side, 1);
  const auto &x = a.positions, &y = b.positions, &m = a.normals, &n = b.normals;
  if (site.second) return {{x[0], y[1], x[1]}, {m[0], n[1], m[1]}};
  return {{x[0], y[0], y[1]}, {m[0], n[0], n[1]}};
}

Vec3d mix(const Vec3d (&of)[3], const Site& site) {
  return of[0] * (1 - site.u - site.v) + of[1] * site.u + of[2] * site.v;
}

double parameter_of(const TubeGrid& grid, const Site& site) {
  return kTurn * (site.segment + segment_fraction(site)) / grid.segments;
}

double chord_at(const TubeGrid& grid, const Corners& corners, const Site& site) {
  const Curve& curve = grid.surface.spine().curve();
  const double t = parameter_of(grid, site);
  const double d = distance_near(curve, curve_point(curve, t), t, mix(corners.positions, site));
  return std::abs(d - grid.surface.tube_radius());
}

double angle_key_at(const TubeGrid& grid, const Corners& corners, const Site& site) {
  const double theta = kTurn * (site.side + side_fraction(site)) / grid.sides;
  const RingFrame frame = grid.surface.spine().frame(parameter_of(grid, site));
  return angle_key(mix(corners.normals, site),
                   frame.normal * std::cos(theta) + frame.binormal * std::sin(theta));
}

/// Climbs from a finding to the worst place in its triangle: steps along the directions of the
/// three edges, halved when none climbs. A step of s leaves an error of about s^2.
template <class Value>
double climbed(const TubeGrid& grid, const Finding& from, Value value_at) {
  constexpr double kWays[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
  const Corners corners = corners_of(grid, from.site);
  Finding best = from;
  for (double step = 0.125; step > 1e-4;) {
    const Finding before = best;
    for (const auto& way : kWays) {
      Site site = before.site;
      site.u += step * way[0];
      site.v += step * way[1];
      if (site.u < 0 || site.v < 0 || site.u + site.v > 1) continue;
      const double value = value_at(grid, corners, site);
      if (value > best.value) best = {value, site};
    }
    if (!(best.value > before.value)) step /= 2;
  }
  return best.value;
}

template <class Value>
double worst_of(const TubeGrid& grid, const WorstFindings& findings, Value value_at) {
  std::vector<double> values(findings.list().size(), 0);
  oneapi::tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
    values[k] = climbed(grid, findings.list()[k], value_at);
  });
  return values.empty() ? 0 : std::ranges::max(values);
}

Deviation deviation_of(const TubeGrid& grid, bool with_normals) {
  const GridScan scan = scan_all(grid, with_normals);
  return {worst_of(grid, scan.chords(), chord_at),
          angle_key_degrees(worst_of(grid, scan.normals(), angle_key_at))};
}

}  // namespace

Deviation measured_deviation(const TubeSurface& surface, int segments, int sides) {
  return deviation_of(tube_grid(surface, segments, sides), true);
}

Deviation measured_deviation(const TubeSurface& surface, int segments, int sides,
                             std::span<const Vec3d> positions, std::span<const Vec3d> normals) {
  const std::size_t count = std::size_t(segments + 1) * std::size_t(sides + 1);
  if (positions.size() != count || normals.size() != count) {
    throw Error(
        fmt::format("a grid of {} segments and {} sides has {} positions and as many normals, got "
                    "{} and {}; give both seams twice",
                    segments, sides, count, positions.size(), normals.size()));
  }
  return deviation_of(tube_grid(surface, segments, sides, positions, normals), true);
}

double measured_chord(const TubeSurface& surface, int segments, int sides) {
  return deviation_of(tube_grid(surface, segments, sides), false).chord;
}

}  // namespace lumaknot
