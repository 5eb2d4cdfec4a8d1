/// The faces of a mesh in the order in which they are written: triangles or quads.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <span>

#include "exporters/text/parallel_writer.h"
#include "scene/triangle_mesh.h"

namespace lumaknot {

using Quad = std::array<std::uint32_t, 4>;

/// The quad with the halves `a` and `b`, which run along their shared edge in opposite directions:
/// the vertex that only `b` has, inserted between the two that it shares with `a`.
inline Quad quad_of(const Triangle& a, const Triangle& b) {
  const auto shared = [&](std::uint32_t v) { return std::ranges::find(b, v) != b.end(); };
  const std::size_t alone = shared(a[0]) ? (shared(a[1]) ? 2 : 1) : 0;  // the corner that b lacks
  const Triangle turned{a[alone], a[(alone + 1) % 3], a[(alone + 2) % 3]};
  const auto other =
      std::ranges::find_if(b, [&](std::uint32_t v) { return std::ranges::find(a, v) == a.end(); });
  assert(other != b.end() && shared(turned[1]) && shared(turned[2]));
  const std::uint32_t fourth = other == b.end() ? b[0] : *other;
  // Begin where `a` does, so that a writer's first corner is the mesh's.
  Quad quad{turned[0], turned[1], fourth, turned[2]};
  std::rotate(quad.begin(), std::ranges::find(quad, a[0]), quad.end());
  return quad;
}

inline std::size_t face_count(const TriangleMesh& mesh, bool quads) {
  return quads ? mesh.triangles.size() / 2 : mesh.triangles.size();
}

/// Writes every face with `format(corners, at)`, where `corners` is a Triangle or a Quad; a face
/// takes at most `face_bytes` plus `corner_bytes` per corner.
template <class Format>
void write_faces(std::ostream& stream, const TriangleMesh& mesh, bool quads, std::size_t face_bytes,
                 std::size_t corner_bytes, const Format& format) {
  const std::span<const Triangle> triangles = mesh.triangles;
  if (quads) {
    write_items(stream, face_count(mesh, true), face_bytes + 4 * corner_bytes,
                [&](std::size_t k, char* at) {
                  return format(quad_of(triangles[2 * k], triangles[2 * k + 1]), at);
                });
  } else {
    write_items(stream, triangles.size(), face_bytes + 3 * corner_bytes,
                [&](std::size_t k, char* at) { return format(triangles[k], at); });
  }
}

}  // namespace lumaknot
