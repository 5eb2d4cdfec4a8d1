/// A scene as a job for lumaknot-gpu, which draws it on OpenGL, OpenGL ES or Vulkan.
#pragma once

#include <filesystem>
#include <span>

#include "scene/shot.h"
#include "scene/spec.h"
#include "shaders/languages/backend.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// How frames are timed, on GL and GLES.
struct GpuTiming {
  int frames = 1;   ///< of each shot, in turns
  int samples = 1;  ///< of coverage and depth a pixel: as many of 1 to 16 as the driver has
  bool cull_back_faces = false;
  bool trilinear = false;
  bool hardware = false;  ///< on a GPU in place of the software driver
};

/// Writes job.json and what it names into `folder`: the mesh, the texture, and for each shot its
/// shaders in `language`. The shot's image will be NAME.bin. With `timing` images and textures have
/// 8 bits a channel. Throws std::runtime_error when a shader does not compile.
void write_gpu_job(const std::filesystem::path& folder, const Scene& scene,
                   std::span<const Shot> shots, Language language, const Programs& programs,
                   const GpuTiming* timing = nullptr);

/// The image that a job drew into `path`: float32 RGBA, the top row first. Throws
/// std::runtime_error when it has not the size.
Image read_gpu_image(const std::filesystem::path& path, int width, int height);

}  // namespace lumaknot::validate
