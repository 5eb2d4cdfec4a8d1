/// What lumaknot-embree draws: a job file with everything that it names, read and checked.
///
/// The file is JSON; a member that is not listed here is refused. Paths are relative to its folder.
///   frames     how many of each draw are timed, in turns, after one of each that is not
///   samples    rays a pixel, 1 to 16 (optional, 1)
///   threads    optional; 0: one for each core
///   mesh       as lumaknot-gpu has it: vertices, count, indices, triangles
///   texture    optional: file (width x height x 4 floats, the row at v = 0 first), width, height;
///              held with 8 bits a channel
///   draws      list: name, scene (scene.json: its view is drawn; its mesh and any texture but a
///              plain colour are not looked at), output (file to write: width x height x 4 floats,
///              top row first, the last frame)
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "validate/gpu/mesh_file.h"

namespace lumaknot::embree {

/// A texture as display hardware has it, repeated in both directions.
struct PackedTexture {
  int width = 0, height = 0;
  std::vector<std::int32_t> texels;  ///< red in the lowest byte; row 0 at v = 0
};

struct Draw {
  std::string name;
  View view;
  Vec3d color;  ///< of the surface where the job has no texture
  std::filesystem::path output;
};

struct Job {
  int frames = 1, samples = 1, threads = 0;
  gpu::Mesh mesh;
  std::optional<PackedTexture> texture;
  std::vector<Draw> draws;
};

/// Reads the job file and the files that it names. Throws Error.
Job read_job(const std::filesystem::path& file);

}  // namespace lumaknot::embree
