/// The meshes of a glTF file's scene, placed by its nodes.
#pragma once

#include <functional>
#include <vector>

#include "exporters/gltf/file.h"
#include "math/vec.h"

namespace lumaknot::gltf {

/// p -> p.x x + p.y y + p.z z + origin.
struct Placement {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{};

  Vec3d turned(const Vec3d& v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3d placed(const Vec3d& p) const { return turned(p) + origin; }

  /// Whether it turns the surface inside out, so that winding must be reversed.
  bool is_mirror() const { return dot(x, cross(y, z)) < 0; }

  /// A normal of the placed surface, on the same side as `n`; its length does not matter.
  Vec3d normal(const Vec3d& n) const {
    const Vec3d v = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return is_mirror() ? -v : v;
  }
};

/// A placed mesh.
struct MeshInstance {
  std::size_t mesh = 0;  ///< index in the file's meshes
  std::size_t node = 0;
  Placement placement;  ///< into our world, +Z up
};

/// The tree of a file's default scene, else of its first, else of all nodes.
class SceneTree {
 public:
  /// Throws Error for a node that refers to something missing, has two parents (this includes
  /// cycles), or has an invalid transform.
  explicit SceneTree(const GltfFile& file);

  /// Calls visit(MeshInstance) for each mesh, in tree order.
  void visit(const std::function<void(const MeshInstance&)>& visit) const;

 private:
  const GltfFile& file_;
  std::vector<int> roots_;
};

}  // namespace lumaknot::gltf
