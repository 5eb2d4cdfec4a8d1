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
};

/// The triangles of `polygons`: cut, also where they are concave, missing normals made smooth, one
/// vertex kept for each set of equal attributes, polygons with a corner twice dropped. With
/// `needs_uvs`, a mesh without texture coordinates is refused; else they are zero. Throws Error
/// calling the file `name` for an edge that more than two polygons share or that two use in the
/// same direction, saying where in the file.
TriangleMesh triangulated(const Polygons& polygons, bool needs_uvs, std::string_view name);

}  // namespace lumaknot
