/// The polygons of a mesh file, as the file has them.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "scene/triangle_mesh.h"

namespace lumaknot {

/// An attribute that a corner does not have.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

/// A corner of a polygon: indices into the arrays of Polygons.
struct PolygonCorner {
  std::uint32_t position = 0;
  std::uint32_t normal = kNoIndex;
  std::uint32_t uv = kNoIndex;
};

/// Polygons that index positions, normals and texture coordinates apart. Readers have checked that
/// every number is finite, every index within its array and every polygon of three corners or more.
struct Polygons {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;          ///< of any length, also zero
  std::vector<Vec2d> uvs;              ///< origin at the bottom left
  std::vector<PolygonCorner> corners;  ///< polygon after polygon
  std::vector<std::uint32_t> sizes;    ///< corners of each polygon, >= 3
  std::vector<std::uint64_t> places;   ///< where each polygon is in the file, in `unit`
  std::string unit = "line";           ///< what places count: "line", "byte", "face"
  std::uint32_t first_index = 0;       ///< what the file calls the first of an array
};

/// The triangles of `polygons`, cut also where they are concave, one vertex kept for each set of
/// equal attributes. Corners at one position that follow each other are one; what then has less
/// than three is dropped. A normal that is missing or zero is made smooth: that of the triangles at
/// its position, weighted by their angles there. With `needs_uvs`, a corner without a texture
/// coordinate is refused; else it is zero. Throws Error calling the file `name` where it has no
/// faces or an edge that more than two of them share or two use in the same direction, saying where
/// in the file.
TriangleMesh triangulated(const Polygons& polygons, bool needs_uvs, std::string_view name);

}  // namespace lumaknot
