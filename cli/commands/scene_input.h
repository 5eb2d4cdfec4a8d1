/// Reads and loads the scene given on the command line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/spec.h"

namespace lumaknot::cli {

/// A scene's description, the folder its file names are relative to, and its own file.
struct SceneInput {
  SceneSpec spec;
  std::filesystem::path folder;
  std::filesystem::path file;  ///< empty: built in
};

/// The scene in the file `source`, on standard input ("-"), or, if there is no such file, the
/// built-in scene of that name. Throws Error.
SceneInput read_scene(const std::string& source);

/// The scene's texture, generated or read. Throws Error.
Texture load_texture(const SceneInput& input);

/// The scene with its mesh and texture, generated or read. Throws Error.
Scene load_scene(const SceneInput& input);

/// Throws Error, naming `flag`, if writing `output` would overwrite an input of the scene: its own
/// file, its texture or its mesh, even under another name.
void check_not_input(const std::filesystem::path& output, const SceneInput& input,
                     std::string_view flag);

}  // namespace lumaknot::cli
