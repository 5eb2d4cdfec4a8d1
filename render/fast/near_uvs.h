/// Texture coordinates in the form that suits single precision best.
#pragma once

#include <vector>

#include "scene/triangle_mesh.h"

namespace lumaknot::fast {

/// A mesh's corners, rearranged so that each triangle's texture coordinates begin near zero.
struct NearUvs {
  std::vector<std::uint32_t> vertices;  ///< the mesh's vertex of each corner
  std::vector<Vec2d> uvs;               ///< of each corner
  std::vector<Triangle> triangles;      ///< of corners
};

/// Subtracts whole tiles from each triangle: a repeating texture looks the same. A vertex whose
/// triangles subtract different tiles becomes several corners. The mesh's vertices come first.
NearUvs near_uvs(const TriangleMesh& mesh);

}  // namespace lumaknot::fast
