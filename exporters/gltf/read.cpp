#include "exporters/gltf/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "exporters/gltf/accessors.h"
#include "exporters/gltf/json.h"
#include "exporters/gltf/nodes.h"

namespace lumaknot::gltf {
namespace {

// Instances can expand a small file, which must still fit in memory; this is also a knot's limit.
constexpr std::uint64_t kMaxVertices = 20'000'000, kMaxTriangles = 40'000'000;

/// A primitive of triangles: the location of its numbers, all within their buffers.
struct Part {
  std::string place;  ///< meshes[0].primitives[1]
  int mode = kGltfTriangles;
  GltfElements positions = {}, normals = {}, uvs = {}, indices = {};  ///< count 0: absent

  std::size_t corners() const { return indices.count > 0 ? indices.count : positions.count; }
  std::size_t triangles() const { return mode == kGltfTriangles ? corners() / 3 : corners() - 2; }
};

/// The indices in the list of corners of triangle `t` (glTF 2.0, section 3.7.2.1).
std::array<std::size_t, 3> corners_of(int mode, std::size_t t) {
  if (mode == kGltfTriangleStrip) return {t, t + 1 + t % 2, t + 2 - t % 2};
  if (mode == kGltfTriangleFan) return {t + 1, t + 2, 0};
  return {3 * t, 3 * t + 1, 3 * t + 2};
}

/// The parts of a mesh, except for points and lines.
class PartFinder {
 public:
  PartFinder(const GltfFile& file, std::size_t mesh) : file_(file), mesh_(mesh) {}

  std::vector<Part> parts() const {
    std::vector<Part> found;
    const auto& primitives = file_.model.meshes[mesh_].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const auto place = fmt::format("meshes[{}].primitives[{}]", mesh_, p);
      const int mode = primitives[p].mode;
      if (mode > kGltfTriangleFan) {
        fail_gltf(file_.name, place + ".mode", fmt::format("must be 0 to 6, got {}", mode));
      }
      if (mode >= kGltfTriangles) found.push_back(part(primitives[p], place));
    }
    return found;
  }

 private:
  Part part(const GltfPrimitive& primitive, const std::string& place) const {
    Part part{.place = place, .mode = primitive.mode};
    part.positions = attribute(primitive.positions, place, "POSITION", GltfType::kVec3);
    part.normals = attribute(primitive.normals, place, "NORMAL", GltfType::kVec3);
    part.uvs = attribute(primitive.uvs, place, "TEXCOORD_0", GltfType::kVec2);
    if (part.positions.count == 0) {
      fail_gltf(file_.name, place + ".attributes.POSITION", "is missing; export it again");
    }
    for (const GltfElements* other : {&part.normals, &part.uvs}) {
      if (other->count == 0 || other->count == part.positions.count) continue;
      fail_gltf(
          file_.name, place + ".attributes",
          fmt::format("has {} and {} elements, which must be equal in number; export it again",
                      part.positions.count, other->count));
    }
    if (primitive.indices != kNoGltfIndex)
      part.indices = indices(primitive.indices, place + ".indices");
    check_corners(part);
    return part;
  }

  GltfElements attribute(int accessor, const std::string& place, std::string_view key,
                         GltfType type) const {
    if (accessor == kNoGltfIndex) return {};
    return elements_of(file_, accessor, type, fmt::format("{}.attributes.{}", place, key));
  }

  GltfElements indices(int accessor, const std::string& place) const {
    const GltfElements elements = elements_of(file_, accessor, GltfType::kScalar, place);
    constexpr std::array kUnsigned{kGltfUnsignedByte, kGltfUnsignedShort, kGltfUnsignedInt};
    if (std::ranges::find(kUnsigned, elements.component) != kUnsigned.end()) return elements;
    fail_gltf(file_.name, place, "must be unsigned integers; export it again");
  }

  void check_corners(const Part& part) const {
    const std::size_t corners = part.corners();
    if (corners >= 3 && (part.mode != kGltfTriangles || corners % 3 == 0)) return;
    fail_gltf(
        file_.name, part.place,
        fmt::format("has {} corners, which is not a whole number of triangles; export it again",
                    corners));
  }

  const GltfFile& file_;
  std::size_t mesh_;
};

/// Collects the triangles of placed parts.
class Gatherer {
 public:
  explicit Gatherer(const GltfFile& file) : file_(file) { polygons_.unit = "face"; }

  void add(const Part& part, const MeshInstance& instance) {
    const Placement& placement = instance.placement;
    bases_ = {std::uint32_t(polygons_.positions.size()), std::uint32_t(polygons_.normals.size()),
              std::uint32_t(polygons_.uvs.size())};
    for (std::size_t i = 0; i < part.positions.count; ++i) {
      const Vec3d p = placement.placed(vector(part.positions, i));
      check_finite(is_finite(p), part, "POSITION", i);
      polygons_.positions.push_back(p);
    }
    for (std::size_t i = 0; i < part.normals.count; ++i) {
      const Vec3d n = placement.normal(vector(part.normals, i));
      check_finite(is_finite(n), part, "NORMAL", i);
      polygons_.normals.push_back(n);
    }
    for (std::size_t i = 0; i < part.uvs.count; ++i) {
      const Vec2d uv{number_at(part.uvs, i, 0), 1 - number_at(part.uvs, i, 1)};
      check_finite(std::isfinite(uv.u) && std::isfinite(uv.v), part, "TEXCOORD_0", i);
      polygons_.uvs.push_back(uv);
    }
    const std::size_t triangles = part.triangles();
    for (std::size_t t = 0; t < triangles; ++t) add_triangle(part, t, placement.is_mirror());
  }

  Polygons take() { return std::move(polygons_); }

 private:
  static Vec3d vector(const GltfElements& elements, std::size_t i) {
    return {number_at(elements, i, 0), number_at(elements, i, 1), number_at(elements, i, 2)};
  }

  void check_finite(bool finite, const Part& part, std::string_view key, std::size_t i) const {
    if (finite) return;
    fail_gltf(file_.name, fmt::format("{}.attributes.{}", part.place, key),
              fmt::format("gives non-finite values for element {}; export it again", i));
  }

  void add_triangle(const Part& part, std::size_t t, bool reversed) {
    std::array<std::uint32_t, 3> vertices{};
    const std::array<std::size_t, 3> places = corners_of(part.mode, t);
    for (std::size_t c = 0; c < 3; ++c) vertices[c] = vertex(part, places[c]);
    if (reversed) std::swap(vertices[1], vertices[2]);
    if (part.normals.count == 0) polygons_.normals.push_back(flat_normal(vertices));
    for (const std::uint32_t v : vertices) {
      polygons_.corners.push_back(
          {bases_[0] + v,
           part.normals.count > 0 ? bases_[1] + v : std::uint32_t(polygons_.normals.size() - 1),
           part.uvs.count > 0 ? bases_[2] + v : kNoIndex});
    }
    polygons_.sizes.push_back(3);
    polygons_.places.push_back(polygons_.sizes.size());
  }

  std::uint32_t vertex(const Part& part, std::size_t corner) const {
    if (part.indices.count == 0) return std::uint32_t(corner);
    const std::uint32_t index = index_at(part.indices, corner);
    if (index < part.positions.count) return index;
    fail_gltf(file_.name, part.place + ".indices",
              fmt::format("refers to vertex {} at {}, but there are {}; export it again", index,
                          corner, part.positions.count));
  }

  Vec3d flat_normal(const std::array<std::uint32_t, 3>& vertices) const {
    const auto at = [&](std::size_t c) { return polygons_.positions[bases_[0] + vertices[c]]; };
    const Vec3d normal = cross(at(1) - at(0), at(2) - at(0));
    return is_finite(normal) ? normal : Vec3d{};
  }

  const GltfFile& file_;
  Polygons polygons_;
  std::array<std::uint32_t, 3> bases_{};  ///< first position, normal, uv of the part
};

using Meshes = std::vector<std::vector<Part>>;

/// Refuses what would fill the memory before allocating any of it.
void check_total(const GltfFile& file, const SceneTree& tree, const Meshes& meshes) {
  std::uint64_t vertices = 0, triangles = 0;
  tree.visit([&](const MeshInstance& instance) {
    for (const Part& part : meshes[instance.mesh]) {
      vertices += part.positions.count;
      triangles += part.triangles();
    }
    if (vertices <= kMaxVertices && triangles <= kMaxTriangles) return;
    fail_gltf(file.name, fmt::format("nodes[{}]", instance.node),
              fmt::format("brings the scene to {} vertices and {} triangles, more than {} and {}; "
                          "export less of it",
                          vertices, triangles, kMaxVertices, kMaxTriangles));
  });
  if (triangles == 0) fail_gltf(file.name, "the scene", "has no triangles; is there a mesh in it?");
}

}  // namespace

Polygons read_gltf(const std::filesystem::path& path, std::string_view name) {
  const auto file = load_gltf(path, name);
  const SceneTree tree(*file);
  Meshes meshes;
  for (std::size_t m = 0; m < file->model.meshes.size(); ++m) {
    meshes.push_back(PartFinder(*file, m).parts());
  }
  check_total(*file, tree, meshes);
  Gatherer gatherer(*file);
  tree.visit([&](const MeshInstance& instance) {
    for (const Part& part : meshes[instance.mesh]) gatherer.add(part, instance);
  });
  return gatherer.take();
}

}  // namespace lumaknot::gltf
