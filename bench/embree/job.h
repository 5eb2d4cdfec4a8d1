/// What lumaknot-embree draws: a job file and all files it names, read and checked.
///
/// The file is JSON; members not listed here are rejected. Paths are relative to its folder.
///   frames     timed frames of each draw, in turns, after one untimed frame of each
///   samples    rays per pixel, 1 to 16 (optional, 1)
///   threads    optional; 0: one per core
///   mesh       as in lumaknot-gpu: vertices, count, indices, triangles
///   texture    optional: file (width x height x 4 floats, the row at v = 0 first), width, height;
///              stored with 8 bits per channel
///   draws      list: name, scene (scene.json: its view is drawn; its mesh and any texture except
///              a plain colour are ignored), output (file to write: width x height x 4 floats,
///              top row first, the last frame)
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/spec.h"
#include "validate/gpu/mesh_file.h"

namespace lumaknot::embree {

/// A texture as on display hardware, repeated in both directions.
struct PackedTexture {
  int width = 0, height = 0;
  std::vector<std::int32_t> texels;  ///< red in the lowest byte; row 0 at v = 0
};

struct Draw {
  std::string name;
  View view;
  Vec3d color;  ///< of the surface if the job has no texture
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
