/// The files that a job names: arrays as they lie in memory, little-endian.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "scene/image.h"
#include "scene/triangle_mesh.h"

namespace lumaknot::validate {

/// The bytes of `values`.
std::string float_bytes(std::span<const float> values);

/// Writes the mesh into `folder`; returns a job's member "mesh".
nlohmann::ordered_json write_job_mesh(const std::filesystem::path& folder,
                                      const TriangleMesh& mesh);

/// Writes the texture as NAME.bin into `folder`, four floats a texel, the bottom row first; returns
/// the members file, width and height.
nlohmann::ordered_json write_job_texture(const std::filesystem::path& folder,
                                         const std::string& name, const TextureImage& texture);

}  // namespace lumaknot::validate
