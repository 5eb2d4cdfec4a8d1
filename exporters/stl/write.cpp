#include <array>

#include "exporters/stl/format.h"
#include "exporters/text/little_endian.h"
#include "exporters/text/numbers.h"
#include "exporters/text/parallel_writer.h"

namespace lumaknot::stl {
namespace {

using Corners = std::array<Vec3d, 3>;

/// The corners as a reader will get them: float32.
Corners corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto corner = [&](std::uint32_t vertex) {
    const Vec3d& p = mesh.positions[vertex];
    return Vec3d{float(p.x), float(p.y), float(p.z)};
  };
  const Triangle& t = mesh.triangles[triangle];
  return {corner(t[0]), corner(t[1]), corner(t[2])};
}

/// Unit; zero where the facet has no area.
Vec3d facet_normal(const Corners& corners) {
  const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double norm = length(normal);
  return norm > 0 ? normal / norm : Vec3d{};
}

void write_binary(std::ostream& stream, const TriangleMesh& mesh) {
  std::array<char, 84> header{"lumaknot"};  // must not begin with "solid", which means text
  put_bytes(header.data() + 80, std::uint32_t(mesh.triangles.size()));
  stream.write(header.data(), header.size());
  write_items(stream, mesh.triangles.size(), 50, [&](std::size_t i, char* at) {
    const Corners corners = corners_of(mesh, i);
    at = put_floats(at, facet_normal(corners));
    for (const Vec3d& corner : corners) at = put_floats(at, corner);
    return put_bytes(at, std::uint16_t{0});  // no attributes
  });
}

void write_text(std::ostream& stream, const TriangleMesh& mesh) {
  constexpr std::size_t kFacetBytes = 80 + 12 * (kFloatBytes + 1);
  stream << "solid lumaknot\n";
  write_items(stream, mesh.triangles.size(), kFacetBytes, [&](std::size_t i, char* at) {
    const Corners corners = corners_of(mesh, i);
    at = put_vector(put_text(at, "facet normal "), facet_normal(corners), ' ');
    at = put_text(at, "\nouter loop\n");
    for (const Vec3d& corner : corners) {
      at = put_vector(put_text(at, "vertex "), corner, ' ');
      *at++ = '\n';
    }
    return put_text(at, "endloop\nendfacet\n");
  });
  stream << "endsolid lumaknot\n";
}

}  // namespace

void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options) {
  if (options.ascii) {
    write_text(stream, mesh);
  } else {
    write_binary(stream, mesh);
  }
}

}  // namespace lumaknot::stl
