/// A glTF file in memory: its model and its buffers.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/gltf/model.h"

namespace lumaknot::gltf {

/// The parsed JSON and the bytes of each buffer.
struct GltfFile {
  GltfFile() = default;
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  std::string name;                        ///< the file's name in errors
  std::string bytes;                       ///< of the file itself
  std::map<std::string, std::string> own;  ///< of its other buffers, by path or number
  std::vector<std::string_view> buffers;   ///< views of the two
  GltfModel model;
};

/// Reads the file at `path` and its buffers. Throws Error as read_gltf() does.
std::unique_ptr<const GltfFile> load_gltf(const std::filesystem::path& path, std::string_view name);

}  // namespace lumaknot::gltf
