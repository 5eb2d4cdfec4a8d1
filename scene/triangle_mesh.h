/// The flat mesh every renderer consumes.
#pragma once

#include <array>
#include <cstdint>

#include "scene/bulk.h"
#include "scene/vec.h"

namespace lumaknot {

using Triangle = std::array<std::uint32_t, 3>;

/// A tangent for normal mapping, as MikkTSpace and glTF have it: `direction` is unit, perpendicular
/// to the vertex's normal and points along increasing u; sign cross(normal, direction) points along
/// increasing v, which is up.
struct Tangent {
  Vec3d direction;
  double sign = 1;  ///< 1 or -1
};

/// Indexed triangles, one position, unit normal and texture coordinate a vertex; vertices on a
/// texture seam are duplicated. Counter-clockwise seen from outside. The three arrays have one
/// length, which every index stays below.
struct TriangleMesh {
  Bulk<Vec3d> positions;  ///< scene units
  Bulk<Vec3d> normals;    ///< unit, outward
  Bulk<Vec2d> uvs;
  Bulk<Triangle> triangles;
  Bulk<Tangent> tangents;  ///< one a vertex, or none at all
  bool quads = false;      ///< triangles 2k and 2k + 1 are the halves of a quad
};

}  // namespace lumaknot
