#include "meshgen/closed_mesh.h"

#include "meshgen/knot_mesh.h"

namespace lumaknot {
namespace {

ClosedMesh::Point to_point(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// The one vertex for all flat vertices at the same grid position.
class Sewing {
 public:
  explicit Sewing(const GridLayout& layout) : layout_(layout) {}

  ClosedMesh::VertexHandle operator()(std::uint32_t flat) const {
    const long long component = flat / layout_.vertices(), in_grid = flat % layout_.vertices();
    const long long i = in_grid / layout_.columns % layout_.segments;
    const long long j = in_grid % layout_.columns % layout_.sides;
    return ClosedMesh::VertexHandle(int((component * layout_.segments + i) * layout_.sides + j));
  }

 private:
  GridLayout layout_;
};

void add_vertices(ClosedMesh& closed, const TriangleMesh& mesh, const Sewing& sewn) {
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (sewn(v).idx() != int(closed.n_vertices())) continue;  // already present
    closed.set_normal(closed.add_vertex(to_point(mesh.positions[v])), to_point(mesh.normals[v]));
  }
}

void add_triangle(ClosedMesh& closed, const TriangleMesh& mesh, const Triangle& triangle,
                  const Sewing& sewn) {
  const auto face = closed.add_face(sewn(triangle[0]), sewn(triangle[1]), sewn(triangle[2]));
  for (const auto halfedge : closed.fh_range(face)) {
    for (const std::uint32_t v : triangle) {
      if (closed.to_vertex_handle(halfedge) != sewn(v)) continue;
      closed.set_texcoord2D(halfedge, {mesh.uvs[v].u, mesh.uvs[v].v});
    }
  }
}

}  // namespace

ClosedMesh closed_mesh(const KnotSpec& knot, const TriangleMesh& mesh) {
  ClosedMesh closed;
  closed.reserve(mesh.positions.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  const Sewing sewn(layout_of(knot));
  add_vertices(closed, mesh, sewn);
  for (const Triangle& triangle : mesh.triangles) add_triangle(closed, mesh, triangle, sewn);
  return closed;
}

}  // namespace lumaknot
