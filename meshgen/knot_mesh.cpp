#include "meshgen/knot_mesh.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "meshgen/frames.h"
#include "scene/check.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

ClosedMesh::Point to_point(const Vec3d& v) { return {v.x, v.y, v.z}; }
Vec3d to_vec(const ClosedMesh::Point& p) { return {p[0], p[1], p[2]}; }

/// Lengths too far from each other or from 1 leave no digits for the tube: a vertex's normal is
/// then not a unit vector, or the vertex not on the tube.
void check_precision(const KnotSpec& knot, double normal, double radius) {
  if (std::abs(normal - 1) < 1e-9 && std::abs(radius / knot.tube_radius - 1) < 1e-3) return;
  throw Error(
      fmt::format("the knot's ring {}, winding {} and tube {} can't be drawn in double "
                  "precision; bring them nearer to 1",
                  knot.ring_radius, knot.winding_radius, knot.tube_radius));
}

void add_ring(ClosedMesh& mesh, const Frame& frame, const KnotSpec& knot) {
  for (int j = 0; j < knot.sides; ++j) {
    const double theta = 2 * std::numbers::pi * j / knot.sides;
    const Vec3d normal = frame.across * std::cos(theta) + frame.over * std::sin(theta);
    const Vec3d position = frame.position + normal * knot.tube_radius;
    check_precision(knot, length(normal), length(position - frame.position));
    mesh.set_normal(mesh.add_vertex(to_point(position)), to_point(normal));
  }
}

/// A corner of the grid of quads: ring i of 0 ... segments, side j of 0 ... sides, both ends kept.
struct Corner {
  int i, j;
};

void add_triangle(ClosedMesh& mesh, const KnotSpec& knot, const std::array<Corner, 3>& corners) {
  const auto vertex = [&](Corner c) {
    return mesh.vertex_handle(unsigned((c.i % knot.segments) * knot.sides + c.j % knot.sides));
  };
  const auto face = mesh.add_face(vertex(corners[0]), vertex(corners[1]), vertex(corners[2]));
  for (const auto halfedge : mesh.fh_range(face)) {
    for (const Corner& c : corners) {
      if (mesh.to_vertex_handle(halfedge) != vertex(c)) continue;
      mesh.set_texcoord2D(halfedge, {double(knot.repeat_u) * c.i / knot.segments,
                                     double(knot.repeat_v) * c.j / knot.sides});
    }
  }
}

}  // namespace

ClosedMesh knot_mesh(const KnotSpec& knot) {
  check_knot(knot, "mesh.knot.");
  ClosedMesh mesh;
  const std::size_t vertices = std::size_t(knot.segments) * std::size_t(knot.sides);
  mesh.reserve(vertices, 3 * vertices, 2 * vertices);
  for (const Frame& frame : closed_frames(knot)) add_ring(mesh, frame, knot);
  for (int i = 0; i < knot.segments; ++i) {
    for (int j = 0; j < knot.sides; ++j) {
      add_triangle(mesh, knot, {{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      add_triangle(mesh, knot, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  }
  return mesh;
}

TriangleMesh flat_mesh(const ClosedMesh& mesh) {
  TriangleMesh flat;
  flat.triangles.reserve(mesh.n_faces());
  std::vector<std::vector<std::uint32_t>> copies(mesh.n_vertices());  // of each closed vertex
  const auto flat_vertex = [&](ClosedMesh::HalfedgeHandle corner) {
    const auto vertex = mesh.to_vertex_handle(corner);
    const Vec2d uv{mesh.texcoord2D(corner)[0], mesh.texcoord2D(corner)[1]};
    auto& known = copies[std::size_t(vertex.idx())];
    for (const std::uint32_t index : known) {
      if (flat.uvs[index] == uv) return index;
    }
    known.push_back(std::uint32_t(flat.positions.size()));
    flat.positions.push_back(to_vec(mesh.point(vertex)));
    flat.normals.push_back(to_vec(mesh.normal(vertex)));
    flat.uvs.push_back(uv);
    return known.back();
  };
  for (const auto face : mesh.faces()) {
    // The halfedge before a face's first one points to its first corner, as it was added.
    const auto last = mesh.prev_halfedge_handle(mesh.halfedge_handle(face));
    const auto first = mesh.next_halfedge_handle(last), second = mesh.next_halfedge_handle(first);
    flat.triangles.push_back({flat_vertex(last), flat_vertex(first), flat_vertex(second)});
  }
  return flat;
}

}  // namespace lumaknot
