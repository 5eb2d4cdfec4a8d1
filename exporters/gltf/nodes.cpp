#include "exporters/gltf/nodes.h"

#include <fmt/format.h>

#include <span>
#include <string>

#include "exporters/gltf/json.h"

namespace lumaknot::gltf {
namespace {

constexpr int kNoParent = -1;

/// glTF's frame, +Y up, in ours.
constexpr Placement kFromGltf{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};

/// `b`, then `a`.
Placement joined(const Placement& a, const Placement& b) {
  return {a.turned(b.x), a.turned(b.y), a.turned(b.z), a.placed(b.origin)};
}

std::string place(std::size_t node) { return fmt::format("nodes[{}]", node); }

std::span<const int> list(const GltfModel& model, const GltfRange& range) {
  return std::span(model.node_lists).subspan(range.first, range.count);
}

Vec3d vec(const double* v) { return {v[0], v[1], v[2]}; }

/// The rotation of a quaternion x, y, z, w of any nonzero length.
Placement rotation(const double* q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const double s = 2 / (x * x + y * y + z * z + w * w);
  return {{1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)},
          {s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w)},
          {s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y)},
          {}};
}

/// `m` column by column.
Placement of_matrix(const double* m) { return {vec(m), vec(m + 4), vec(m + 8), vec(m + 12)}; }

/// A node's placement relative to its parent.
Placement local(const GltfModel& model, const GltfNode& node) {
  const auto numbers = [&](int at) { return &model.numbers[std::size_t(at)]; };
  if (node.matrix != kNoGltfIndex) return of_matrix(numbers(node.matrix));
  Placement placement;
  if (node.rotation != kNoGltfIndex) placement = rotation(numbers(node.rotation));
  if (node.scale != kNoGltfIndex) {
    const auto [x, y, z] = vec(numbers(node.scale));
    placement = {placement.x * x, placement.y * y, placement.z * z, {}};
  }
  if (node.translation != kNoGltfIndex) placement.origin = vec(numbers(node.translation));
  return placement;
}

/// Checks nodes, all before any is placed, and finds the roots of the scene.
class NodeCheck {
 public:
  explicit NodeCheck(const GltfFile& file)
      : file_(file), model_(file.model), parents_(file.model.nodes.size(), kNoParent) {
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      adopt_children(i);
      check_mesh(i);
      check_transform(i);
    }
  }

  std::vector<int> roots() const {
    if (model_.scenes.empty()) return orphans();
    if (std::size_t(model_.scene) >= model_.scenes.size()) {
      fail_gltf(file_.name, "scene",
                fmt::format("is {}, but there are {} scenes; export it again", model_.scene,
                            model_.scenes.size()));
    }
    const auto listed = list(model_, model_.scenes[std::size_t(model_.scene)]);
    std::vector<bool> is_listed(parents_.size());
    for (std::size_t i = 0; i < listed.size(); ++i) {
      const auto where = [&] { return fmt::format("scenes[{}].nodes[{}]", model_.scene, i); };
      check_node(listed[i], where);
      const auto node = std::size_t(listed[i]);
      if (parents_[node] != kNoParent || is_listed[node]) {
        fail_gltf(file_.name, where(),
                  fmt::format("is {}, which another node or the list already has; export it again",
                              node));
      }
      is_listed[node] = true;
    }
    return {listed.begin(), listed.end()};
  }

 private:
  template <class Where>
  void check_node(int index, Where where) const {
    if (std::size_t(index) < parents_.size()) return;
    fail_gltf(
        file_.name, where(),
        fmt::format("is {}, but there are {} nodes; export it again", index, parents_.size()));
  }

  /// With at most one parent per node, the trees of the roots have no cycles.
  void adopt_children(std::size_t parent) {
    const auto children = list(model_, model_.nodes[parent].children);
    for (std::size_t c = 0; c < children.size(); ++c) {
      const auto where = [&] { return fmt::format("{}.children[{}]", place(parent), c); };
      check_node(children[c], where);
      int& known = parents_[std::size_t(children[c])];
      if (known != kNoParent) {
        fail_gltf(
            file_.name, where(),
            fmt::format("is {}, already a child of nodes[{}]; copy that node", children[c], known));
      }
      known = int(parent);
    }
  }

  void check_mesh(std::size_t node) const {
    const int mesh = model_.nodes[node].mesh;
    if (mesh == kNoGltfIndex || std::size_t(mesh) < model_.meshes.size()) return;
    fail_gltf(
        file_.name, place(node) + ".mesh",
        fmt::format("is {}, but there are {} meshes; export it again", mesh, model_.meshes.size()));
  }

  void check_transform(std::size_t node) const {
    const auto& [mesh, matrix, translation, rotation, scale, children] = model_.nodes[node];
    if (matrix != kNoGltfIndex) check_matrix(&model_.numbers[std::size_t(matrix)], node);
    if (rotation != kNoGltfIndex) check_rotation(&model_.numbers[std::size_t(rotation)], node);
  }

  void check_matrix(const double* m, std::size_t node) const {
    if (m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1) return;
    fail_gltf(file_.name, place(node) + ".matrix",
              fmt::format("must have a last row of 0, 0, 0, 1, got {}, {}, {}, {}", m[3], m[7],
                          m[11], m[15]));
  }

  void check_rotation(const double* q, std::size_t node) const {
    if (is_finite(rotation(q).x)) return;
    fail_gltf(
        file_.name, place(node) + ".rotation",
        fmt::format("must be a unit quaternion, got [{}, {}, {}, {}]", q[0], q[1], q[2], q[3]));
  }

  std::vector<int> orphans() const {
    std::vector<int> found;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      if (parents_[i] == kNoParent) found.push_back(int(i));
    }
    return found;
  }

  const GltfFile& file_;
  const GltfModel& model_;
  std::vector<int> parents_;
};

}  // namespace

SceneTree::SceneTree(const GltfFile& file) : file_(file), roots_(NodeCheck(file).roots()) {}

void SceneTree::visit(const std::function<void(const MeshInstance&)>& visit) const {
  struct Step {
    int node;
    Placement outer;
  };
  const GltfModel& model = file_.model;
  std::vector<Step> ahead;
  for (const int root : roots_) {
    ahead.push_back({root, kFromGltf});
    while (!ahead.empty()) {
      const auto [index, outer] = ahead.back();
      ahead.pop_back();
      const GltfNode& node = model.nodes[std::size_t(index)];
      const Placement placement = joined(outer, local(model, node));
      if (node.mesh != kNoGltfIndex) {
        visit({std::size_t(node.mesh), std::size_t(index), placement});
      }
      const auto children = list(model, node.children);
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        ahead.push_back({*child, placement});
      }
    }
  }
}

}  // namespace lumaknot::gltf
