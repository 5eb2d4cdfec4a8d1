/// Texture coordinates as single precision holds them best.
#pragma once

#include <vector>

#include "scene/triangle_mesh.h"

namespace lumaknot {

/// A mesh's corners again, so that each triangle's texture coordinates begin near zero.
struct NearUvs {
  std::vector<std::uint32_t> vertices;  ///< of each corner, its vertex of the mesh
  std::vector<Vec2d> uvs;               ///< of each corner
  std::vector<Triangle> triangles;      ///< of corners
};

/// Takes whole tiles off each triangle: a texture that repeats shows the same. A vertex whose
/// triangles take off different tiles becomes several corners. The mesh's vertices come first.
NearUvs near_uvs(const TriangleMesh& mesh);

}  // namespace lumaknot
