#include "meshgen/knot_mesh.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <span>

#include "scene/check.h"
#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot {
namespace {

/// Lengths too far from each other or from 1 leave no digits for the tube: a frame is then not
/// orthonormal, or a vertex is not on the tube.
void check_precision(const KnotSpec& knot, const RingFrame& frame) {
  for (const Vec3d& arm : {frame.normal, frame.binormal}) {
    const Vec3d position = frame.position + arm * knot.tube_radius;
    const Vec3d spoke = (position - frame.position) / knot.tube_radius;
    if (std::abs(dot(arm, arm) - 1) < 2e-9 && std::abs(dot(spoke, spoke) - 1) < 2e-3) continue;
    throw Error(
        fmt::format("the knot's ring {}, winding {} and tube {} can't be drawn in double "
                    "precision; bring them nearer to 1",
                    knot.major_radius, knot.minor_radius, knot.tube_radius));
  }
}

/// The angle of a column, and its texture coordinate.
struct Column {
  SinCos angle;
  double v;
};

std::vector<Column> columns_of(const KnotSpec& knot, const GridLayout& layout) {
  const std::vector<SinCos> angles = sin_cos_table(layout.sides);
  std::vector<Column> columns;
  columns.reserve(std::size_t(layout.columns));
  for (int j = 0; j < layout.columns; ++j) {
    // the last column equals the first to the bit
    columns.push_back(
        {angles[std::size_t(j % layout.sides)], double(knot.repeat_v) * j / layout.sides});
  }
  return columns;
}

/// Texture coordinate u of each ring.
std::vector<double> ring_us(const KnotSpec& knot, std::span<const double> arc_lengths) {
  std::vector<double> us;
  us.reserve(arc_lengths.size());
  for (std::size_t i = 0; i < arc_lengths.size(); ++i) {
    const double share = knot.unwrap == Unwrap::kParameter ? double(i) / knot.segments
                                                           : arc_lengths[i] / arc_lengths.back();
    us.push_back(knot.repeat_u * share);
  }
  return us;
}

/// The rings of one component; vertices from `base` on.
struct Tube {
  std::vector<RingFrame> frames;
  std::vector<double> us;
  std::size_t base;
};

void fill_ring(TriangleMesh& mesh, const Tube& tube, std::span<const Column> columns, int ring,
               double radius) {
  const std::size_t segments = tube.frames.size() - 1;  // the last ring equals the first to the bit
  // Copies, which stores into the mesh can't change.
  const RingFrame frame = tube.frames[std::size_t(ring) % segments];
  const double u = tube.us[std::size_t(ring)];
  std::size_t at = tube.base + std::size_t(ring) * columns.size();
  for (const auto& [angle, v] : columns) {
    const Vec3d normal = frame.normal * angle.c + frame.binormal * angle.s;
    const auto& [x, y, z] = normal;
    mesh.positions[at] = frame.position + normal * radius;
    mesh.normals[at] = {x, y, z};  // a struct copy would go through memory, twice as slow
    mesh.uvs[at] = {u, v};
    ++at;
  }
}

/// The corners of the two halves of quad (i, j): 0 is (i, j), 1 (i + 1, j), 2 (i + 1, j + 1),
/// 3 (i, j + 1).
using Cut = std::array<std::array<std::uint8_t, 3>, 2>;

Cut cut_of(Convention convention) {
  switch (convention) {
    case Convention::kThree:
      return {{{0, 1, 3}, {1, 2, 3}}};
    case Convention::kBabylon:
      return {{{3, 1, 0}, {3, 2, 1}}};
    default:
      return {{{0, 1, 2}, {0, 2, 3}}};
  }
}

void fill_quads(TriangleMesh& mesh, const GridLayout& layout, Cut cut, std::size_t base,
                std::size_t first, int ring) {
  Triangle* const row = &mesh.triangles[first + 2 * std::size_t(ring) * std::size_t(layout.sides)];
  const std::uint32_t here = std::uint32_t(base + std::size_t(ring) * std::size_t(layout.columns));
  const std::uint32_t next = here + std::uint32_t(layout.columns);
  const std::array<std::uint32_t, 4> corners{here, next, next + 1, here + 1};  // for side 0
  const auto& [a, b, c] = cut[0];
  const auto& [d, e, f] = cut[1];
  const Triangle one{corners[a], corners[b], corners[c]}, two{corners[d], corners[e], corners[f]};
  for (std::uint32_t j = 0; j < std::uint32_t(layout.sides); ++j) {
    Triangle* const halves = row + 2 * std::size_t(j);
    halves[0] = {one[0] + j, one[1] + j, one[2] + j};
    halves[1] = {two[0] + j, two[1] + j, two[2] + j};
  }
  if (layout.columns > layout.sides) return;
  for (std::size_t half = 0; half < 2; ++half) {  // the last side ends at the first column
    Triangle& last = row[2 * std::size_t(layout.sides - 1) + half];
    for (std::size_t k = 0; k < 3; ++k) last[k] -= cut[half][k] >= 2 ? layout.columns : 0;
  }
}

TriangleMesh sized(std::size_t vertices, std::size_t triangles) {
  TriangleMesh mesh;
  mesh.positions.resize(vertices);
  mesh.normals.resize(vertices);
  mesh.uvs.resize(vertices);
  mesh.triangles.resize(triangles);
  mesh.quads = true;
  return mesh;
}

/// Babylon.js's ComputeNormals(): the normalised sum of the unit normals of a vertex's faces, each
/// duplicate on its own.
void average_face_normals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), {});
  for (const Triangle& t : mesh.triangles) {
    const Vec3d b = mesh.positions[t[1]];
    const Vec3d face = normalize(cross(mesh.positions[t[0]] - b, mesh.positions[t[2]] - b));
    for (const std::uint32_t corner : t) mesh.normals[corner] = mesh.normals[corner] + face;
  }
  for (Vec3d& normal : mesh.normals) normal = normalize(normal);
}

}  // namespace

GridLayout layout_of(const KnotSpec& knot) {
  const bool shares_column = knot.convention == Convention::kBabylon;
  return {knot.segments, knot.sides, shares_column ? knot.sides : knot.sides + 1};
}

std::vector<Curve> centre_lines(const KnotSpec& knot) {
  if (!has_fixed_winding(knot.convention)) return components(knot);
  return {{knot.p, knot.q, knot.major_radius, knot.minor_radius}};
}

TriangleMesh knot_mesh(const KnotSpec& knot) {
  check_knot(knot, "mesh.knot.");
  const GridLayout layout = layout_of(knot);
  const std::vector<Curve> lines = centre_lines(knot);
  TriangleMesh mesh = sized(lines.size() * std::size_t(layout.vertices()),
                            lines.size() * std::size_t(layout.triangles()));
  const std::vector<Column> columns = columns_of(knot, layout);
  const Cut cut = cut_of(knot.convention);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Spine spine(lines[k]);
    const std::vector<double> lengths = spine.arc_lengths(knot.segments);
    const Tube tube{ring_frames(spine, knot.frames, lengths), ring_us(knot, lengths),
                    k * std::size_t(layout.vertices())};
    for (const RingFrame& frame : tube.frames) check_precision(knot, frame);
    const std::size_t first = k * std::size_t(layout.triangles());
    tbb::parallel_for(tbb::blocked_range<int>(0, knot.segments + 1), [&](const auto& rings) {
      for (int i = rings.begin(); i < rings.end(); ++i) {
        fill_ring(mesh, tube, columns, i, knot.tube_radius);
        if (i < knot.segments) fill_quads(mesh, layout, cut, tube.base, first, i);
      }
    });
  }
  if (knot.convention == Convention::kBabylon) average_face_normals(mesh);
  return mesh;
}

}  // namespace lumaknot
