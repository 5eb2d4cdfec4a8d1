/// The parts of a .glb file.
#pragma once

#include <string_view>

namespace lumaknot::gltf {

/// The JSON and the binary chunk of a file; the latter is empty if absent.
struct GltfChunks {
  std::string_view json, binary;
};

/// The chunks of a .glb file, each within `bytes`; for a .gltf file, all of it as JSON. Throws
/// Error naming the byte.
GltfChunks gltf_chunks(std::string_view bytes, std::string_view name);

}  // namespace lumaknot::gltf
