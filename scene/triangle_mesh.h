/// The flat mesh every renderer consumes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/vec.h"

namespace lumaknot {

using Triangle = std::array<std::uint32_t, 3>;

/// Indexed triangles, one position, unit normal and texture coordinate a vertex; vertices on a
/// texture seam are duplicated. Counter-clockwise seen from outside. The three arrays have one
/// length, which every index stays below.
struct TriangleMesh {
  std::vector<Vec3d> positions;  ///< scene units
  std::vector<Vec3d> normals;    ///< unit, outward
  std::vector<Vec2d> uvs;
  std::vector<Triangle> triangles;
};

}  // namespace lumaknot
