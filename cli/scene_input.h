/// Scenes from the command line, and into memory.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace lumaknot {

/// A scene's description and the folder that its file names are relative to.
struct SceneInput {
  SceneSpec spec;
  std::filesystem::path folder;
};

/// The scene in the file `source`, on standard input ("-"), or built in under that name when there
/// is no such file. Throws Error.
SceneInput read_scene(const std::string& source);

/// The scene's texture made or read. Throws Error.
Texture load_texture(const SceneInput& input);

/// The scene in memory: its mesh built or read, its texture made or read. Throws Error.
Scene load_scene(const SceneInput& input);

}  // namespace lumaknot
