/// The polygons of a mesh file, as stored in the file.
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

/// Polygons that index positions, normals and texture coordinates separately. Readers have checked
/// that every number is finite, every index within its array and every polygon has at least three
/// corners.
struct Polygons {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;          ///< of any length, including zero
  std::vector<Vec2d> uvs;              ///< origin at the bottom left
  std::vector<PolygonCorner> corners;  ///< polygon after polygon
  std::vector<std::uint32_t> sizes;    ///< corners of each polygon, >= 3
  std::vector<std::uint64_t> places;   ///< the place of each polygon in the file, in `unit`
  std::string unit = "line";           ///< the unit of places: "line", "byte", "face"
  std::uint32_t first_index = 0;       ///< the file's index of the first element of an array
};

/// The triangles of `polygons`, also cut where they are concave, with one vertex kept for each set
/// of equal attributes. Consecutive corners at one position are merged; polygons then left with
/// fewer than three are dropped. A normal that is missing or zero becomes smooth: that of the
/// triangles at its position, weighted by their angles there. With `needs_uvs`, a corner without a
/// texture coordinate is refused; otherwise it is zero. Throws Error calling the file `name` when
/// it has no faces or an edge that more than two of them share or two use in the same direction,
/// naming the place in the file.
TriangleMesh triangulated(const Polygons& polygons, bool needs_uvs, std::string_view name);

}  // namespace lumaknot
