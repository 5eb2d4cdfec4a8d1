// Mesh files through OpenMesh's writers.
#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <fstream>

#include "exporters/mesh_file.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

struct FlatTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
};
using FlatMesh = OpenMesh::TriMesh_ArrayKernelT<FlatTraits>;

FlatMesh to_open_mesh(const TriangleMesh& mesh, std::string_view flag) {
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
  if (result.n_faces() != mesh.triangles.size()) {
    throw Error(
        fmt::format("{}: {} of {} triangles meet more than one other at an edge, which OBJ "
                    "and PLY files are not written with",
                    flag, mesh.triangles.size() - result.n_faces(), mesh.triangles.size()));
  }
  return result;
}

}  // namespace

void check_mesh_output(const std::filesystem::path& path, const MeshFileOptions&,
                       std::string_view flag) {
  const std::string extension = path.extension().string();
  if (extension == ".obj" || extension == ".ply") return;
  throw Error(fmt::format("{} {} must end in .obj or .ply", flag, path.string()));
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& file_options, std::string_view flag) {
  check_mesh_output(path, file_options, flag);
  constexpr int kDigits = 9;  // enough to tell every float32 from its neighbours
  omlog().disable();
  omerr().disable();
  AtomicFile file(path, flag);
  std::ofstream stream(file.temporary(), std::ios::binary);
  OpenMesh::IO::Options options =
      OpenMesh::IO::Options::VertexNormal | OpenMesh::IO::Options::VertexTexCoord;
  if (path.extension() == ".ply") options += OpenMesh::IO::Options::Binary;
  const bool written = OpenMesh::IO::write_mesh(to_open_mesh(mesh, flag), stream,
                                                path.extension().string(), options, kDigits);
  stream.close();
  if (!written || !stream) {
    throw Error(fmt::format("{} {} can't be written; is the disk full?", flag, path.string()));
  }
  file.commit();
}

}  // namespace lumaknot
