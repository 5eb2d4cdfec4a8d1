#include "meshgen/certificate.h"

#include <algorithm>
#include <limits>
#include <span>

#include "math/angle.h"
#include "scene/presets.h"

namespace lumaknot {
namespace {

/// The angle between two vectors of any length, in degrees; exact near 0.
double angle_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * kDegrees;
}

/// The vertices of one component, ring by ring.
class Rings {
 public:
  Rings(const TriangleMesh& mesh, const GridLayout& layout, std::size_t component)
      : mesh_(mesh), layout_(layout), base_(component * std::size_t(layout.vertices())) {}

  const Vec3d& position(int i, int j) const { return mesh_.positions[index(i, j)]; }
  double u(int i) const { return mesh_.uvs[index(i, 0)].u; }

  /// The area vector of ring i's polygon, normal to its plane (Newell).
  Vec3d plane(int i) const {
    Vec3d sum;
    const Vec3d& from = position(i, 0);
    for (int j = 1; j + 1 < layout_.sides; ++j) {
      sum = sum + cross(position(i, j) - from, position(i, j + 1) - from);
    }
    return sum;
  }

 private:
  std::size_t index(int i, int j) const {
    return base_ + std::size_t(i) * std::size_t(layout_.columns) + std::size_t(j % layout_.columns);
  }
  const TriangleMesh& mesh_;
  GridLayout layout_;
  std::size_t base_;
};

double ring_tilt(const Rings& rings, const Curve& line, int segments) {
  double max = 0;
  for (int i = 0; i < segments; ++i) {
    const Vec3d tangent = curve_point(line, ring_parameter(i, segments)).first;
    const Vec3d plane = rings.plane(i);
    max = std::max(max, angle_between(dot(plane, tangent) < 0 ? -plane : plane, tangent));
  }
  return max;
}

void widen(Interval<double>& range, double value) {
  range.min = std::min(range.min, value);
  range.max = std::max(range.max, value);
}

Stretch stretch_of(const Rings& rings, std::span<const double> lengths, const KnotSpec& knot) {
  constexpr Interval<double> kNone{std::numeric_limits<double>::max(), 0};
  Stretch stretch{kNone, kNone, kNone};
  const double tile = lengths.back() / knot.repeat_u;  // along, on average
  const double share = 2 * kPi * knot.tube_radius / knot.sides;
  for (int i = 0; i < knot.segments; ++i) {
    const double step = (rings.u(i + 1) - rings.u(i)) * tile;
    widen(stretch.along, (lengths[std::size_t(i) + 1] - lengths[std::size_t(i)]) / step);
    for (int j = 0; j < knot.sides; ++j) {
      widen(stretch.surface, length(rings.position(i + 1, j) - rings.position(i, j)) / step);
      widen(stretch.around, length(rings.position(i, j + 1) - rings.position(i, j)) / share);
    }
  }
  return stretch;
}

void measure_closed(Certificate& result, const KnotSpec& knot, const TriangleMesh& mesh) {
  const ClosedMesh closed = closed_mesh(knot, mesh);
  result.connected_components = connected_components(closed);
  result.volume = volume(closed);
  result.area = area(closed);
}

bool has_exact_rings(const KnotSpec& knot) { return knot.frames == FrameRule::kRotationMinimizing; }

/// The first component's vertices in measured_deviation()'s layout. Quads that are cut along the
/// other diagonal are mirrored, the sides reversed.
Bulk<Vec3d> grid_positions(const Rings& rings, const KnotSpec& knot) {
  const bool mirrored = has_fixed_winding(knot.convention);
  Bulk<Vec3d> positions;
  for (int i = 0; i <= knot.segments; ++i) {
    for (int j = 0; j <= knot.sides; ++j) {
      positions.push_back(rings.position(i, mirrored ? knot.sides - j : j));
    }
  }
  return positions;
}

/// The largest angle between a vertex's normal and the exact tube's normal at the nearest point, in
/// degrees.
double normal_error_at_vertices(const TriangleMesh& mesh, const KnotSpec& knot, const Curve& line) {
  const GridLayout layout = layout_of(knot);
  double max = 0;
  for (std::size_t v = 0; v < std::size_t(layout.vertices()); ++v) {
    double t = ring_parameter(int(v) / layout.columns, knot.segments);
    for (int step = 0; step < 8; ++step) {  // Newton's method on (x - C) . C' = 0
      const CurvePoint c = curve_point(line, t);
      const Vec3d arm = mesh.positions[v] - c.position;
      t += dot(arm, c.first) / (dot(c.first, c.first) - dot(arm, c.second));
    }
    const Vec3d exact = mesh.positions[v] - curve_point(line, t).position;
    max = std::max(max, angle_between(mesh.normals[v], exact));
  }
  return max;
}

void measure_deviation(Certificate& result, const KnotSpec& knot, const TriangleMesh& mesh,
                       const TubeSurface& surface) {
  const GridLayout layout = layout_of(knot);
  if (has_exact_rings(knot)) {
    const std::size_t count = std::size_t(layout.vertices());
    result.measured = measured_deviation(surface, knot.segments, knot.sides,
                                         std::span(mesh.positions).first(count),
                                         std::span(mesh.normals).first(count));
    result.bound = deviation_bound(surface, knot.segments, knot.sides);
    return;
  }
  const Bulk<Vec3d> positions = grid_positions(Rings(mesh, layout, 0), knot);
  result.measured = {
      measured_deviation(surface, knot.segments, knot.sides, positions, positions).chord,
      normal_error_at_vertices(mesh, knot, surface.spine().curve())};
}

}  // namespace

Certificate certify(const KnotSpec& knot, const TriangleMesh& mesh) {
  Certificate result;
  measure_closed(result, knot, mesh);
  result.file_vertices = mesh.positions.size();
  const std::vector<Curve> lines = centre_lines(knot);
  const Spine spine(lines.front());
  result.length = double(lines.size()) * spine.length();
  result.exact_volume = kPi * knot.tube_radius * knot.tube_radius * result.length;
  result.exact_area = 2 * kPi * knot.tube_radius * result.length;
  result.holonomy = spine.holonomy() * kDegrees;
  const std::vector<double> lengths = spine.arc_lengths(knot.segments);
  const std::vector<RingFrame> frames = ring_frames(spine, knot.frames, lengths);
  result.twist = twist(frames) * kDegrees;
  result.closing_error = angle_between(frames.front().normal, frames.back().normal);
  const GridLayout layout = layout_of(knot);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double tilt = ring_tilt(Rings(mesh, layout, k), lines[k], knot.segments);
    result.ring_tilt = std::max(result.ring_tilt, tilt);
  }
  result.stretch = stretch_of(Rings(mesh, layout, 0), lengths, knot);
  result.clearance = clearance(components(knot));
  measure_deviation(result, knot, mesh, TubeSurface(spine, knot.tube_radius));
  return result;
}

}  // namespace lumaknot
