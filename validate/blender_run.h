/// Running Blender on a script of ours.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validate/renderer.h"

namespace lumaknot {

/// The command line that runs `script` without a window, without the user's settings, and ends
/// with code 7 when the script fails.
std::vector<std::string> blender_command(const std::filesystem::path& program,
                                         const std::string& script,
                                         const std::vector<std::string>& script_arguments);

/// Has Blender write `scene`, drawn as `shot`, to the .blend file `path` with its texture inside;
/// the file is there whole or not at all. Throws Error naming `flag` or saying what is missing.
void save_blend(const Scene& scene, const Shot& shot, const std::filesystem::path& path,
                const Programs& programs, std::string_view flag);

}  // namespace lumaknot
