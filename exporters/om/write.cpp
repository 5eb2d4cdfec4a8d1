#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "exporters/om/format.h"
#include "system/error.h"

namespace lumaknot::om {
namespace {

struct FlatTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
};
using FlatMesh = OpenMesh::TriMesh_ArrayKernelT<FlatTraits>;

FlatMesh to_open_mesh(const TriangleMesh& mesh) {
  FlatMesh result;
  result.reserve(mesh.positions.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d &p = mesh.positions[i], &n = mesh.normals[i];
    const auto vertex = result.add_vertex({p.x, p.y, p.z});
    result.set_normal(vertex, {n.x, n.y, n.z});
    result.set_texcoord2D(vertex, {mesh.uvs[i].u, mesh.uvs[i].v});
  }
  for (const Triangle& t : mesh.triangles) {
    result.add_face(FlatMesh::VertexHandle(int(t[0])), FlatMesh::VertexHandle(int(t[1])),
                    FlatMesh::VertexHandle(int(t[2])));
  }
  return result;
}

}  // namespace

void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions&) {
  omlog().disable();
  omerr().disable();
  const FlatMesh surface = to_open_mesh(mesh);
  if (const std::size_t lost = mesh.triangles.size() - surface.n_faces()) {
    throw Error(
        fmt::format("OM files can't hold a surface in which {} of {} triangles meet more than "
                    "one other at an edge; write .obj, .ply or .stl",
                    lost, mesh.triangles.size()));
  }
  const OpenMesh::IO::Options options =
      OpenMesh::IO::Options::VertexNormal | OpenMesh::IO::Options::VertexTexCoord;
  if (!OpenMesh::IO::write_mesh(surface, stream, ".om", options)) stream.setstate(std::ios::badbit);
}

}  // namespace lumaknot::om
