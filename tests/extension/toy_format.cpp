// A mesh format in one file: a line of nine numbers per triangle, the positions of its corners.
#include <fmt/format.h>

#include "exporters/mesh/format.h"
#include "exporters/text/scanner.h"

namespace lumaknot {
namespace {

Polygons read_toy(std::string_view bytes, std::string_view name) {
  Polygons polygons;
  for (TextScanner text(bytes, name); text.next_line();) {
    for (int corner = 0; corner < 3; ++corner) {
      const double x = text.number(), y = text.number(), z = text.number();
      polygons.corners.push_back({std::uint32_t(polygons.positions.size())});
      polygons.positions.push_back({x, y, z});
    }
    polygons.sizes.push_back(3);
    polygons.places.push_back(text.line());
  }
  return polygons;
}

void write_toy(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions&) {
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      const Vec3d& p = mesh.positions[vertex];
      stream << fmt::format("{} {} {} ", float(p.x), float(p.y), float(p.z));
    }
    stream << '\n';
  }
}

}  // namespace

extern const MeshFormat kToyFormat{.endings = {".toy"},
                                   .read = read_whole<read_toy>,
                                   .write = write_whole<write_toy>,
                                   .has_text = true};

}  // namespace lumaknot
