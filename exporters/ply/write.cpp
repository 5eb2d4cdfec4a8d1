#include <fmt/format.h>

#include "exporters/mesh/faces.h"
#include "exporters/ply/format.h"
#include "exporters/text/little_endian.h"
#include "exporters/text/numbers.h"

namespace lumaknot::ply {
namespace {

std::string header(const TriangleMesh& mesh, const MeshFileOptions& options) {
  std::string text =
      fmt::format("ply\nformat {} 1.0\ncomment made by lumaknot\nelement vertex {}\n",
                  options.ascii ? "ascii" : "binary_little_endian", mesh.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"}) {
    text += fmt::format("property float {}\n", name);
  }
  return text +
         fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                     face_count(mesh, options.quads));
}

void write_binary(std::ostream& stream, const TriangleMesh& mesh, bool quads) {
  write_items(stream, mesh.positions.size(), 8 * sizeof(float), [&](std::size_t i, char* at) {
    at = put_floats(put_floats(at, mesh.positions[i]), mesh.normals[i]);
    return put_bytes(put_bytes(at, float(mesh.uvs[i].u)), float(mesh.uvs[i].v));
  });
  write_faces(stream, mesh, quads, 1, sizeof(std::uint32_t), [](const auto& corners, char* at) {
    return put_bytes(put_bytes(at, std::uint8_t(corners.size())), corners);
  });
}

void write_text(std::ostream& stream, const TriangleMesh& mesh, bool quads) {
  write_items(stream, mesh.positions.size(), 8 * (kFloatBytes + 1), [&](std::size_t i, char* at) {
    at = put_vector(at, mesh.positions[i], ' ');
    *at++ = ' ';
    at = put_vector(at, mesh.normals[i], ' ');
    *at++ = ' ';
    at = put_vector(at, mesh.uvs[i], ' ');
    *at++ = '\n';
    return at;
  });
  write_faces(stream, mesh, quads, 2, kIntegerBytes + 1,
              [](const auto& corners, char* at) { return put_polygon(at, corners); });
}

}  // namespace

void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options) {
  stream << header(mesh, options);
  (options.ascii ? write_text : write_binary)(stream, mesh, options.quads);
}

}  // namespace lumaknot::ply
