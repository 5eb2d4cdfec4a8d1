/// Geometry of one triangle.
#pragma once

#include "scene/triangle_mesh.h"

namespace lumaknot {

/// Along the outward normal; its length is twice the area.
inline Vec3d area_vector(const TriangleMesh& mesh, const Triangle& t) {
  return cross(mesh.positions[t[1]] - mesh.positions[t[0]],
               mesh.positions[t[2]] - mesh.positions[t[0]]);
}

/// Unit, outward; zero if the triangle has no area.
inline Vec3d triangle_normal(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3d area = area_vector(mesh, t);
  const double size = length(area);
  return size > 0 ? area / size : Vec3d{};
}

}  // namespace lumaknot
