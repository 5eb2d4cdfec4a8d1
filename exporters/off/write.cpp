#include <fmt/format.h>

#include "exporters/mesh/faces.h"
#include "exporters/mesh/weld.h"
#include "exporters/off/format.h"
#include "exporters/text/numbers.h"

namespace lumaknot::off {

void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options) {
  const Weld weld = lumaknot::weld(mesh.positions);
  stream << fmt::format("OFF\n{} {} 0\n", weld.count, face_count(mesh, options.quads));
  write_items(stream, mesh.positions.size(), 3 * (kFloatBytes + 1), [&](std::size_t i, char* at) {
    if (weld.repeats[i]) return at;
    at = put_vector(at, mesh.positions[i], ' ');
    *at++ = '\n';
    return at;
  });
  write_faces(stream, mesh, options.quads, 2, kIntegerBytes + 1, [&](auto corners, char* at) {
    for (std::uint32_t& corner : corners) corner = weld.position[corner];
    return put_polygon(at, corners);
  });
}

}  // namespace lumaknot::off
