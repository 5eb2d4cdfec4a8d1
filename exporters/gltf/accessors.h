/// The numbers of a glTF file's accessors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "exporters/gltf/file.h"

namespace lumaknot::gltf {

/// An element's values in a buffer, all within it.
struct GltfElements {
  const char* first = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;      ///< bytes from one to the next
  int component = 0;           ///< a GltfComponent
  bool is_normalized = false;  ///< integers represent [-1, 1] or [0, 1]
};

/// The elements of the accessor `index`, which must be of `type`. `path` is the place in the file
/// that refers to it. Throws Error when they exceed their view or the view exceeds its buffer.
GltfElements elements_of(const GltfFile& file, int index, GltfType type, const std::string& path);

/// Component `c` of element `i` as a number.
double number_at(const GltfElements& elements, std::size_t i, std::size_t c);

/// Element `i` of unsigned integers.
std::uint32_t index_at(const GltfElements& elements, std::size_t i);

}  // namespace lumaknot::gltf
