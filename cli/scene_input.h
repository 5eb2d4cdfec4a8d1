/// Scenes from the command line, and into memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace lumaknot {

/// A scene's description, the folder that its file names are relative to, and its own file.
struct SceneInput {
  SceneSpec spec;
  std::filesystem::path folder;
  std::filesystem::path file;  ///< empty: built in
};

/// The scene in the file `source`, on standard input ("-"), or built in under that name when there
/// is no such file. Throws Error.
SceneInput read_scene(const std::string& source);

/// The scene's texture made or read. Throws Error.
Texture load_texture(const SceneInput& input);

/// The scene in memory: its mesh built or read, its texture made or read. Throws Error.
Scene load_scene(const SceneInput& input);

/// Throws Error, naming `flag`, when writing `output` would overwrite what the scene is read from:
/// its own file, its texture or its mesh, under whatever name.
void check_not_input(const std::filesystem::path& output, const SceneInput& input,
                     std::string_view flag);

}  // namespace lumaknot
