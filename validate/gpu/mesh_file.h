/// The mesh that a job names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "validate/gpu/fields.h"

namespace lumaknot::gpu {

/// Triangles with shared vertices.
struct Mesh {
  std::vector<float> vertices;         ///< 8 per vertex: position xyz, normal xyz, texture uv
  std::vector<std::uint32_t> indices;  ///< 3 per triangle, each below the number of vertices
};

inline constexpr int kFloatsPerVertex = 8;

/// Reads the mesh of the object `fields`, its files in `folder`. Throws Error.
Mesh read_mesh(Fields fields, const std::filesystem::path& folder);

}  // namespace lumaknot::gpu
