// OM files through OpenMesh's own reader.
#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <sstream>

#include "exporters/om/chunks.h"
#include "exporters/om/format.h"
#include "exporters/text/scanner.h"

namespace lumaknot::om {
namespace {

struct OmTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};
using OmMesh = OpenMesh::PolyMesh_ArrayKernelT<OmTraits>;

OmMesh open_mesh(const OmFile& file, std::string_view name) {
  using OpenMesh::IO::Options;
  omlog().disable();
  omerr().disable();
  Options options = Options::Binary;
  if (file.has_normals) options += Options::VertexNormal;
  if (file.has_uvs) options += Options::VertexTexCoord;
  if (file.has_corner_uvs) options += Options::FaceTexCoord;
  std::istringstream stream(file.bytes, std::ios::binary);
  OmMesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, stream, ".om", options)) {
    throw Error(fmt::format("{} can't be read by OpenMesh; {}", name, kExportAgain));
  }
  return mesh;
}

/// Throws Error with the index of the `what` unless its numbers can be used.
template <class Vector>
Vector usable(const Vector& vector, std::string_view what, std::size_t i, std::string_view name) {
  for (const double component : vector) {
    if (is_usable(component)) continue;
    throw file_error(name, what, i,
                     fmt::format("{} is not a finite float32 number; {}", component, kExportAgain));
  }
  return vector;
}

Polygons attributes_of(const OmMesh& mesh, const OmFile& file, std::string_view name) {
  Polygons polygons;
  for (const auto v : mesh.vertices()) {
    const auto index = std::size_t(v.idx());
    const auto p = usable(mesh.point(v), "vertex", index, name);
    polygons.positions.push_back({p[0], p[1], p[2]});
    if (file.has_normals) {
      const auto n = usable(mesh.normal(v), "vertex", index, name);
      polygons.normals.push_back({n[0], n[1], n[2]});
    }
    if (file.has_uvs && !file.has_corner_uvs) {
      const auto uv = usable(mesh.texcoord2D(v), "vertex", index, name);
      polygons.uvs.push_back({uv[0], uv[1]});
    }
  }
  return polygons;
}

}  // namespace

Polygons read(std::string_view bytes, std::string_view name) {
  const OmFile file = checked_om(bytes, name);
  const OmMesh mesh = open_mesh(file, name);
  Polygons polygons = attributes_of(mesh, file, name);
  polygons.unit = "face";
  for (const auto face : mesh.faces()) {
    const std::size_t before = polygons.corners.size();
    for (const auto h : mesh.fh_range(face)) {
      const auto vertex = std::uint32_t(mesh.to_vertex_handle(h).idx());
      PolygonCorner corner{vertex, file.has_normals ? vertex : kNoIndex,
                           file.has_uvs ? vertex : kNoIndex};
      if (file.has_corner_uvs) {
        corner.uv = std::uint32_t(polygons.uvs.size());
        const auto uv = usable(mesh.texcoord2D(h), "face", std::size_t(face.idx()), name);
        polygons.uvs.push_back({uv[0], uv[1]});
      }
      polygons.corners.push_back(corner);
    }
    polygons.sizes.push_back(std::uint32_t(polygons.corners.size() - before));
    polygons.places.push_back(std::uint64_t(face.idx()));
  }
  return polygons;
}

}  // namespace lumaknot::om
