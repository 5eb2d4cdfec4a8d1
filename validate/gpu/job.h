/// What to draw: a job file and all files it names, read and checked.
///
/// The file is JSON; members not listed here are rejected. Paths are relative to its folder.
///   api        "gl" (3.3 core), "gles" (3.0) or "vulkan" (1.0)
///   width, height   pixels
///   mesh       optional: vertices (file of 8 floats each: position, normal, uv), count, indices
///              (file of uint32), triangles. Attributes are at locations 0, 1 and 2. Without a
///              mesh three vertices are drawn, placed by the vertex shader by their number.
///   textures   optional list: name (a sampler's; GL, GLES), binding (Vulkan, descriptor set 0),
///              sampler_binding (Vulkan, optional: a separate sampler), file (width x height x 4
///              floats, the row at v = 0 first), width, height, filter "linear", "nearest" or
///              (GL, GLES) "trilinear".
///              A shader may also declare texture and sampler separately at the one binding.
///   draws      list: name (optional), vertex, fragment (GLSL, or SPIR-V for Vulkan), vertex_entry,
///              fragment_entry (optional, "main"), output (file to write: width x height x 4
///              floats, top row first), and
///              - GL, GLES: uniforms, a list of name and values: 1 to 4 numbers make a float or
///                vector, 9 and 16 a matrix, column by column;
///              - Vulkan: uniform_block (file in std140 layout), uniform_binding (optional, 0).
/// GL and GLES only, all optional:
///   driver     "software" (as the caller's environment leaves it) or "hardware": a GPU's
///   format     "float" or "bytes": the image's and the textures' channels
///   samples    1 to 16 of coverage and depth per pixel, or as many as the driver has
///   cull       "none" or "back": drops triangles seen clockwise
///   frames     timed frames of each draw, in turns, after some untimed ones; one more is
///              written
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "validate/gpu/mesh_file.h"

namespace lumaknot::gpu {

enum class Api { kGl, kGles, kVulkan };

enum class Filter { kNearest, kLinear, kTrilinear };

/// A texture of four floats per texel, repeated in both directions.
struct Texture {
  std::string name;  ///< its sampler uniform; GL and GLES
  int binding = 0;   ///< in descriptor set 0; Vulkan
  int sampler = -1;  ///< binding of a separate sampler, or -1: the two are combined; Vulkan
  int width = 0, height = 0;
  Filter filter = Filter::kNearest;
  std::vector<float> texels;  ///< RGBA, row 0 at v = 0
};

/// A uniform outside any block: 1 to 4 floats, or 9 or 16 of a matrix, column by column.
struct Uniform {
  std::string name;
  std::vector<float> values;
};

/// A stage's code.
struct Shader {
  std::string where;  ///< its name in errors: "draws[0].vertex phong.vert"
  std::string code;   ///< GLSL, or a SPIR-V module's bytes
  std::string entry = "main";
};

/// One picture of the mesh, or of one triangle that the vertex shader places by its vertex number.
struct Draw {
  std::string where;  ///< its name in errors: "draws[0]"
  std::string name;   ///< empty if it has none
  Shader vertex, fragment;
  std::vector<Uniform> uniforms;             ///< GL and GLES
  std::optional<std::string> uniform_block;  ///< bytes in std140 layout; Vulkan
  int uniform_binding = 0;                   ///< of the block, in descriptor set 0
  std::filesystem::path output;              ///< RGBA floats, top row first
};

struct Job {
  Api api = Api::kGl;
  int width = 0, height = 0;  ///< pixels
  bool hardware = false;      ///< on a GPU's driver
  bool bytes = false;         ///< channels of the image and the textures are bytes, else floats
  int samples = 1;
  bool cull_back_faces = false;
  int frames = 0;  ///< timed per draw; 0: each is drawn once
  std::optional<Mesh> mesh;
  std::vector<Texture> textures;
  std::vector<Draw> draws;
};

/// The API named "gl", "gles" or "vulkan". Throws Error naming `field`.
Api api_named(const std::string& name, const std::string& field);

/// Reads the job file and the files that it names, relative to its folder. Throws Error.
Job read_job(const std::filesystem::path& file);

/// The bytes of one picture.
inline std::size_t image_floats(const Job& job) {
  return std::size_t(job.width) * std::size_t(job.height) * 4;
}

}  // namespace lumaknot::gpu
