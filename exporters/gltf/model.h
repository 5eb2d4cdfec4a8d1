/// The parts of a glTF file's JSON that are read, as plain structs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace lumaknot::gltf {

/// An index that is absent from the file.
inline constexpr int kNoGltfIndex = -1;

/// Numbers of the specification, sections 5.1.3 and 5.24.4.
enum GltfComponent {
  kGltfByte = 5120,
  kGltfUnsignedByte = 5121,
  kGltfShort = 5122,
  kGltfUnsignedShort = 5123,
  kGltfUnsignedInt = 5125,
  kGltfFloat = 5126
};
enum GltfMode { kGltfTriangles = 4, kGltfTriangleStrip = 5, kGltfTriangleFan = 6 };

/// The first four equal the number of their components.
enum class GltfType : std::uint8_t { kScalar = 1, kVec2, kVec3, kVec4, kMat2, kMat3, kMat4 };

struct GltfBuffer {
  std::uint64_t size = 0;
  std::optional<std::string> uri;
};

struct GltfView {
  int buffer = kNoGltfIndex;
  std::uint64_t offset = 0, size = 0, stride = 0;  ///< stride 0: absent
};

struct GltfAccessor {
  int view = kNoGltfIndex;
  int component = 0;
  std::uint64_t offset = 0, count = 0;
  GltfType type = GltfType::kScalar;
  bool is_normalized = false;
};

/// Accessors of a part of a mesh.
struct GltfPrimitive {
  int positions = kNoGltfIndex, normals = kNoGltfIndex, uvs = kNoGltfIndex;
  int indices = kNoGltfIndex;
  int mode = kGltfTriangles;
};

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
};

/// A range of a list of the model.
struct GltfRange {
  std::uint32_t first = 0, count = 0;
};

/// The transforms are indices into GltfModel::numbers where theirs begin.
struct GltfNode {
  int mesh = kNoGltfIndex;
  int matrix = kNoGltfIndex;       ///< 16 numbers, column by column
  int translation = kNoGltfIndex;  ///< 3
  int rotation = kNoGltfIndex;     ///< 4: x, y, z, w
  int scale = kNoGltfIndex;        ///< 3
  GltfRange children;              ///< of GltfModel::node_lists
};

/// Indices are not negative, but not checked against their arrays. A file of a few MB can have a
/// million nodes, so these are small and, in a deque, never copied.
struct GltfModel {
  std::string version;
  std::vector<std::string> extensions_required;
  int scene = 0;
  std::vector<GltfRange> scenes;  ///< of node_lists
  std::deque<GltfNode> nodes;
  std::vector<int> node_lists;  ///< the children of nodes and the roots of scenes
  std::vector<double> numbers;
  std::vector<GltfMesh> meshes;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfView> views;
  std::vector<GltfBuffer> buffers;
};

}  // namespace lumaknot::gltf
