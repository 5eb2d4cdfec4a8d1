/// Running Blender on a script of ours.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exporters/blender/scene.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// A Blender, and what it is to draw with.
struct BlenderRun {
  std::vector<std::string> command;  ///< what runs scene.py, up to the script's own arguments
  std::vector<std::string> environment;
  std::string engine;  ///< "cycles" or "eevee"
  blender::ShotShaders shaders = blender::ShotShaders::kNodes;
  std::chrono::duration<double> time_limit;
  std::optional<Sampling> sampling = {};  ///< of Cycles
};

/// Draws the shots in one process; those that Blender can't draw are skipped. Throws
/// std::runtime_error when it can't be run.
Rendering draw_in_blender(const BlenderRun& blender, const Scene& scene,
                          std::span<const Shot> shots);

/// Draws all `shots` of what blender_package() made of them under the name "scene". Throws as
/// above.
Rendering draw_package(const BlenderRun& blender, const Package& package, const View& view,
                       std::span<const Shot> shots);

/// The command line that runs `script` without a window, without the user's settings, and ends
/// with code 7 when the script fails.
std::vector<std::string> blender_command(const std::filesystem::path& program,
                                         const std::string& script);

/// Has Blender write `scene`, drawn as `shot`, to the .blend file `path` with its texture inside;
/// the file is there whole or not at all. Throws Error naming `flag` or saying what is missing.
void save_blend(const Scene& scene, const Shot& shot, const std::filesystem::path& path,
                const Programs& programs, std::string_view flag);

}  // namespace lumaknot::validate
