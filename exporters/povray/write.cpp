#include <fmt/format.h>

#include "exporters/povray/format.h"
#include "exporters/text/numbers.h"
#include "exporters/text/parallel_writer.h"

namespace lumaknot::povray {
namespace {

template <class Vector>
void write_vectors(std::ostream& stream, std::string_view name, const Bulk<Vector>& all) {
  stream << fmt::format("  {} {{ {}\n", name, all.size());
  write_items(stream, all.size(), 3 * (kFloatBytes + 1) + 2, [&](std::size_t i, char* at) {
    *at++ = '<';
    return put_text(put_vector(at, all[i], ','), ">\n");
  });
  stream << "  }\n";
}

void write_triangles(std::ostream& stream, const Bulk<Triangle>& triangles) {
  stream << fmt::format("  face_indices {{ {}\n", triangles.size());
  write_items(stream, triangles.size(), 3 * (kIntegerBytes + 1) + 2, [&](std::size_t i, char* at) {
    char between = '<';
    for (const std::uint32_t vertex : triangles[i]) {
      *at++ = between;
      at = put_integer(at, vertex);
      between = ',';
    }
    return put_text(at, ">\n");
  });
  stream << "  }\n";
}

}  // namespace

void write_pov_mesh(std::ostream& stream, const TriangleMesh& mesh) {
  write_vectors(stream, "vertex_vectors", mesh.positions);
  write_vectors(stream, "normal_vectors", mesh.normals);
  write_vectors(stream, "uv_vectors", mesh.uvs);
  write_triangles(stream, mesh.triangles);
}

void write_pov_include(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions&) {
  stream << "// Made by lumaknot. object { lumaknot_mesh texture { uv_mapping ... } }\n"
            "#declare lumaknot_mesh = mesh2 {\n";
  write_pov_mesh(stream, mesh);
  stream << "}\n";
}

}  // namespace lumaknot::povray
