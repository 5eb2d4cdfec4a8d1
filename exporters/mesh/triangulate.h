/// Triangulation of polygons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lumaknot {

/// Whether every corner of the polygon turns left, seen from where it is counter-clockwise: the
/// plane's normal is Newell's.
bool is_convex(std::span<const Vec3d> corners);

/// The maximum number of corners of a non-convex polygon: the time is quadratic in it.
inline constexpr std::size_t kMaxConcaveCorners = 4096;

/// size - 2 triangles, as indices of `corners`, wound as the polygon is. They cover the area of a
/// polygon that does not cross itself; otherwise they are arbitrary triangles. A convex one is cut
/// from its first corner. Needs at least 3 corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3d> corners);

}  // namespace lumaknot
