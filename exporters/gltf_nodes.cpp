#include "exporters/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "exporters/gltf_outline.h"

namespace lumaknot {
namespace {

constexpr int kNoParent = -1;

/// glTF's frame, +Y up, in ours.
constexpr Placement kFromGltf{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};

/// First `b`, then `a`.
Placement joined(const Placement& a, const Placement& b) {
  return {a.turned(b.x), a.turned(b.y), a.turned(b.z), a.placed(b.origin)};
}

Vec3d vec(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// The rotation of a quaternion x, y, z, w of any length but zero.
Placement rotation(const std::vector<double>& q, const std::string& place,
                   const std::string& name) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const double s = 2 / (x * x + y * y + z * z + w * w);
  if (!std::isfinite(s)) {
    fail_gltf(name, place + ".rotation",
              fmt::format("must be a unit quaternion, got [{}, {}, {}, {}]", x, y, z, w));
  }
  return {{1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)},
          {s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w)},
          {s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y)},
          {}};
}

/// Walks the tree of a scene's nodes.
class Walk {
 public:
  explicit Walk(const GltfFile& file) : file_(file), nodes_(file.model.nodes) {
    parents_.assign(nodes_.size(), kNoParent);
    for (std::size_t i = 0; i < nodes_.size(); ++i) adopt_children(i);
  }

  std::vector<MeshInstance> instances() {
    struct Step {
      std::size_t node;
      Placement outer;
    };
    std::vector<Step> ahead;
    for (const std::size_t root : std::views::reverse(roots())) ahead.push_back({root, kFromGltf});
    std::vector<MeshInstance> found;
    while (!ahead.empty()) {
      const auto [index, outer] = ahead.back();
      ahead.pop_back();
      const tinygltf::Node& node = nodes_[index];
      const Placement placement = joined(outer, local(index));
      if (node.mesh >= 0) found.push_back({mesh_of(index), index, placement});
      for (const int child : std::views::reverse(node.children)) {
        ahead.push_back({std::size_t(child), placement});
      }
    }
    return found;
  }

 private:
  static std::string place(std::size_t node) { return fmt::format("nodes[{}]", node); }

  void check_node(int index, const std::string& where) const {
    if (std::size_t(index) < nodes_.size()) return;
    fail_gltf(file_.name, where,
              fmt::format("is {}, but there are {} nodes; export it again", index, nodes_.size()));
  }

  /// With one parent a node at most, what hangs on a root has no cycles.
  void adopt_children(std::size_t parent) {
    const std::vector<int>& children = nodes_[parent].children;
    for (std::size_t c = 0; c < children.size(); ++c) {
      const auto where = fmt::format("{}.children[{}]", place(parent), c);
      check_node(children[c], where);
      int& known = parents_[std::size_t(children[c])];
      if (known != kNoParent) {
        fail_gltf(
            file_.name, where,
            fmt::format("is {}, a child of nodes[{}] already; copy that node", children[c], known));
      }
      known = int(parent);
    }
  }

  std::vector<std::size_t> roots() const {
    const tinygltf::Model& model = file_.model;
    if (model.scenes.empty()) return orphans();
    const int scene = std::max(model.defaultScene, 0);
    if (std::size_t(scene) >= model.scenes.size()) {
      fail_gltf(file_.name, "scene",
                fmt::format("is {}, but there are {} scenes; export it again", scene,
                            model.scenes.size()));
    }
    const std::vector<int>& listed = model.scenes[std::size_t(scene)].nodes;
    std::vector<bool> is_listed(nodes_.size());
    for (std::size_t i = 0; i < listed.size(); ++i) {
      const auto where = fmt::format("scenes[{}].nodes[{}]", scene, i);
      check_node(listed[i], where);
      const std::size_t node = std::size_t(listed[i]);
      if (parents_[node] != kNoParent || is_listed[node]) {
        fail_gltf(file_.name, where,
                  fmt::format("is {}, which another node or the list has already; export it again",
                              node));
      }
      is_listed[node] = true;
    }
    return {listed.begin(), listed.end()};
  }

  std::vector<std::size_t> orphans() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (parents_[i] == kNoParent) found.push_back(i);
    }
    return found;
  }

  std::size_t mesh_of(std::size_t node) const {
    const std::size_t mesh = std::size_t(nodes_[node].mesh), known = file_.model.meshes.size();
    if (mesh < known) return mesh;
    fail_gltf(file_.name, place(node) + ".mesh",
              fmt::format("is {}, but there are {} meshes; export it again", mesh, known));
  }

  /// A node within its parent.
  Placement local(std::size_t index) const {
    const tinygltf::Node& node = nodes_[index];
    if (!node.matrix.empty()) return of_matrix(node.matrix, place(index));
    Placement placement;
    if (!node.rotation.empty()) placement = rotation(node.rotation, place(index), file_.name);
    if (!node.scale.empty()) {
      const auto [x, y, z] = vec(node.scale);
      placement = {placement.x * x, placement.y * y, placement.z * z, {}};
    }
    if (!node.translation.empty()) placement.origin = vec(node.translation);
    return placement;
  }

  /// `m` column by column.
  Placement of_matrix(const std::vector<double>& m, const std::string& where) const {
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
      fail_gltf(file_.name, where + ".matrix",
                fmt::format("must have a last row of 0, 0, 0, 1, got {}, {}, {}, {}", m[3], m[7],
                            m[11], m[15]));
    }
    const auto column = [&](std::size_t i) { return Vec3d{m[i], m[i + 1], m[i + 2]}; };
    return {column(0), column(4), column(8), column(12)};
  }

  const GltfFile& file_;
  const std::vector<tinygltf::Node>& nodes_;
  std::vector<int> parents_;
};

}  // namespace

std::vector<MeshInstance> instances_of(const GltfFile& file) { return Walk(file).instances(); }

}  // namespace lumaknot
