/// Sampling a grid's triangles against the exact tube: shared by deviation.h and lean_grid.h.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshgen/surface.h"

namespace lumaknot {

/// A grid on a tube, vertex (i, j) at t = ring_parameter(i, segments), theta = 2 pi j / sides. The
/// quad (i, j) is cut into (i,j),(i+1,j),(i+1,j+1) and (i,j),(i+1,j+1),(i,j+1).
struct TubeGrid {
  const TubeSurface& surface;
  int segments, sides;  ///< >= 3
  std::span<const Vec3d> positions,
      normals;  ///< (segments + 1) x (sides + 1), or empty: the tube's
  /// At the sides j + 0, 1/3, 1/2, 2/3. All empty where only a few sides are needed and no normals.
  std::vector<SinCos> whole, third, half, rest;
};

/// The grid of the tube's own points, or of given ones.
TubeGrid tube_grid(const TubeSurface& surface, int segments, int sides,
                   std::span<const Vec3d> positions = {}, std::span<const Vec3d> normals = {});

/// A point of a triangle of the quad (segment, side): of its three corners, in the order above, the
/// second has the weight u and the third v.
struct Site {
  int segment = 0, side = 0;
  bool second = false;  ///< which of the quad's two triangles
  double u = 0, v = 0;
};

/// The deviation of a triangle at a site.
struct Finding {
  double value = 0;
  Site site;
};

/// The worst findings in descending order; equal ones in the grid's order, so that the result does
/// not depend on the order of work.
class WorstFindings {
 public:
  /// The value that a finding must exceed to be kept.
  double threshold() const { return list_.size() < kKept ? 0 : list_.back().value; }
  double worst() const { return list_.empty() ? 0 : list_.front().value; }
  void offer(double value, const Site& site);
  void merge(const WorstFindings& other);
  const std::vector<Finding>& list() const { return list_; }

 private:
  static constexpr std::size_t kKept = 32;
  std::vector<Finding> list_;
};

/// Consecutive vertices of one ring, with the deviations of the vertices and of their edges'
/// midpoints.
struct GridRow {
  int segment = 0, side = 0;  ///< of the first vertex
  RingFrame frame;
  std::vector<Vec3d> positions, normals;
  std::vector<double> vertex, edge;  ///< distance to the centre line - r
};

/// `count` edges of the ring `segment`, starting at `side`.
GridRow grid_row(const TubeGrid& grid, int segment, int side, int count);

/// Distance to the centre line - r at a triangle's corners and its edges' midpoints.
struct TriangleOffsets {
  std::array<double, 3> corner;
  double edge01, edge12, edge02;
};

/// The worst places of the scanned strips. Every edge's midpoint is evaluated, and the stationary
/// point of the quadratic through a triangle's corners and midpoints if it lies inside and is
/// expected to be among the worst. For a quadratic surface this is exact.
class GridScan {
 public:
  explicit GridScan(bool with_normals) : with_normals_(with_normals) {}

  /// Scans the quads between two rings.
  void strip(const TubeGrid& grid, const GridRow& low, const GridRow& high);
  void merge(const GridScan& other);

  const WorstFindings& chords() const { return chords_; }    ///< |distance - r|, scene units
  const WorstFindings& normals() const { return normals_; }  ///< see angle_key()

 private:
  void triangle(const TubeGrid& grid, Site site, const std::array<Vec3d, 3>& corners,
                const TriangleOffsets& offsets);
  void normals_of(const TubeGrid& grid, const GridRow& low, const GridRow& high);

  bool with_normals_;
  WorstFindings chords_, normals_;
};

/// Increases with the angle between `a`, of any length, and the unit vector `b`: the square of its
/// sine, and 2 minus that beyond a right angle.
double angle_key(const Vec3d& a, const Vec3d& b);

/// The angle of an angle_key(), in degrees.
double angle_key_degrees(double key);

/// The fraction of its segment at which a site lies, and the fraction of its side.
double segment_fraction(const Site& site);
double side_fraction(const Site& site);

}  // namespace lumaknot
