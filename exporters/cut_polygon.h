/// Polygons cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/vec.h"

namespace lumaknot {

/// Whether every corner of the polygon turns to its left, seen from where it is counter-clockwise:
/// the plane's normal is Newell's.
bool is_convex(std::span<const Vec3d> corners);

/// The most corners of a polygon that is not convex: cutting takes time with their square.
inline constexpr std::size_t kMostConcaveCorners = 4096;

/// size - 2 triangles, as indices of `corners`, wound as the polygon is. They cover the area of a
/// polygon that does not cross itself; where it does they are some triangles. A convex one is cut
/// from its first corner. Takes 3 corners or more.
std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<const Vec3d> corners);

}  // namespace lumaknot
