#include "exporters/mesh/faces.h"
#include "exporters/mesh/weld.h"
#include "exporters/obj/format.h"
#include "exporters/text/numbers.h"

namespace lumaknot::obj {
namespace {

template <class Vector>
char* put_line(char* at, std::string_view key, const Vector& v) {
  at = put_vector(put_text(at, key), v, ' ');
  *at++ = '\n';
  return at;
}

/// position/texture coordinate/normal, counted from 1.
char* put_corner(char* at, const Weld& weld, std::uint32_t vertex) {
  *at++ = ' ';
  at = put_integer(at, weld.position[vertex] + 1);
  char* const own = at;
  *at++ = '/';
  at = put_integer(at, vertex + 1);
  return put_text(at, {own, std::size_t(at - own)});
}

}  // namespace

void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options) {
  constexpr std::size_t kLineBytes = 3 * (kFloatBytes + 1) + 3;
  const Weld weld = lumaknot::weld(mesh.positions);
  const std::size_t count = mesh.positions.size();
  write_items(stream, count, kLineBytes, [&](std::size_t i, char* at) {
    return weld.repeats[i] ? at : put_line(at, "v ", mesh.positions[i]);
  });
  write_items(stream, count, kLineBytes,
              [&](std::size_t i, char* at) { return put_line(at, "vt ", mesh.uvs[i]); });
  write_items(stream, count, kLineBytes,
              [&](std::size_t i, char* at) { return put_line(at, "vn ", mesh.normals[i]); });
  write_faces(stream, mesh, options.quads, 2, 3 * (kIntegerBytes + 1),
              [&](const auto& corners, char* at) {
                *at++ = 'f';
                for (const std::uint32_t vertex : corners) at = put_corner(at, weld, vertex);
                *at++ = '\n';
                return at;
              });
}

}  // namespace lumaknot::obj
