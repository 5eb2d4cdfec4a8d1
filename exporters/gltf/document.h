/// A glTF document under construction: shared by meshes and scenes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>

#include "scene/spec.h"

namespace lumaknot::gltf {

/// The document of one mesh on one node, to which a scene adds. Its one buffer is the output of
/// write_arrays(), then the bytes of the added views, each padded to 4.
class GltfDocument {
 public:
  /// Throws Error when `mesh` has no triangles or a position beyond float32.
  explicit GltfDocument(const TriangleMesh& mesh);

  nlohmann::ordered_json json;  ///< all except "buffers"

  /// Adds a view of the next `size` bytes of the buffer and returns its index.
  std::size_t add_view(std::uint64_t size);
  /// Adds `value` to the array `key` of the document and returns its index.
  std::size_t add(const char* key, nlohmann::ordered_json value);

  std::uint64_t buffer_size() const { return buffer_size_; }

  /// The text, with the buffer embedded or, if a name is given, in a file of that name in the same
  /// folder.
  std::string text(std::string_view buffer_file = {}) const;

 private:
  std::size_t add_array(std::size_t count, int component, const char* type, std::size_t size,
                        int target);

  std::uint64_t buffer_size_ = 0;
};

/// The matrix of a node at `position` with the given axes, in our frame: from those axes to glTF's.
nlohmann::ordered_json gltf_matrix(const CameraFrame& axes, const Vec3d& position);

/// The URI of a file in the document's folder.
std::string gltf_uri(std::string_view name);

/// Our point or vector in glTF's frame, +Y up. Exact.
Vec3d to_gltf(const Vec3d& v);

/// Writes the float32 arrays and indices that the document of `mesh` describes.
void write_arrays(std::ostream& stream, const TriangleMesh& mesh);

/// Writes `document`, its buffer consisting of the arrays of `mesh` and `tail`, as a .glb file.
void write_container(std::ostream& stream, const GltfDocument& document, const TriangleMesh& mesh,
                     std::string_view tail);

}  // namespace lumaknot::gltf
