/// The meshes of a glTF file's scene, each where its nodes place it. Inside exporters only.
#pragma once

#include <functional>
#include <vector>

#include "exporters/gltf_file.h"
#include "scene/vec.h"

namespace lumaknot {

/// p -> p.x x + p.y y + p.z z + origin.
struct Placement {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{};

  Vec3d turned(const Vec3d& v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3d placed(const Vec3d& p) const { return turned(p) + origin; }

  /// Whether it turns the surface inside out, so that windings must be reversed.
  bool is_mirror() const { return dot(x, cross(y, z)) < 0; }

  /// A normal of the placed surface, on the same side as `n`; its length is of no account.
  Vec3d normal(const Vec3d& n) const {
    const Vec3d v = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return is_mirror() ? -v : v;
  }
};

/// A mesh at a place.
struct MeshInstance {
  std::size_t mesh = 0;  ///< within the file's meshes
  std::size_t node = 0;
  Placement placement;  ///< into our world, +Z up
};

/// The tree of a file's default scene, or of its first, or without one of all nodes.
class SceneTree {
 public:
  /// Throws Error for a node that names what is not there, that has two parents (cycles too), or
  /// whose transform is none.
  explicit SceneTree(const GltfFile& file);

  /// Calls visit(MeshInstance) for each mesh, in the order of the tree.
  void visit(const std::function<void(const MeshInstance&)>& visit) const;

 private:
  const GltfFile& file_;
  std::vector<int> roots_;
};

}  // namespace lumaknot
