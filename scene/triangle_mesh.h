/// The flat mesh every renderer consumes.
#pragma once

#include <array>
#include <cstdint>

#include "math/vec.h"
#include "system/bulk.h"

namespace lumaknot {

using Triangle = std::array<std::uint32_t, 3>;

/// A tangent for normal mapping, as defined by MikkTSpace and glTF: `direction` is unit,
/// perpendicular to the vertex's normal and points along increasing u; sign cross(normal,
/// direction) points along increasing v, which is up.
struct Tangent {
  Vec3d direction;
  double sign = 1;  ///< 1 or -1
};

/// Indexed triangles with one position, unit normal and texture coordinate per vertex; vertices on
/// a texture seam are duplicated. Counter-clockwise seen from outside. The three arrays have the
/// same length, and every index is below it.
struct TriangleMesh {
  Bulk<Vec3d> positions;  ///< scene units
  Bulk<Vec3d> normals;    ///< unit, outward
  Bulk<Vec2d> uvs;
  Bulk<Triangle> triangles;
  Bulk<Tangent> tangents;  ///< one per vertex, or empty
  bool quads = false;      ///< triangles 2k and 2k + 1 are the halves of a quad
};

}  // namespace lumaknot
