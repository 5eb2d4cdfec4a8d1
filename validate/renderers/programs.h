/// The programs that renderers run.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>

namespace lumaknot::validate {

/// A program that renderers run.
struct ProgramInfo {
  std::string_view flag;     ///< of the command line, to give another: "--povray"
  std::string_view name;     ///< looked for on PATH, unless `place` says where else
  std::string_view meaning;  ///< in --help
  std::string_view remedy;   ///< how to get it
  std::string_view place = {};
};

inline constexpr ProgramInfo kPovrayProgram{"--povray", "povray", "POV-Ray executable",
                                            "install with apt-get install povray"};
inline constexpr ProgramInfo kBlenderProgram{"--blender", "blender", "Blender executable",
                                             "install with apt-get install blender"};
inline constexpr ProgramInfo kXvfbProgram{"--xvfb", "Xvfb", "X server for Eevee",
                                          "install with apt-get install xvfb"};
inline constexpr ProgramInfo kGlslangProgram{"--glslang", "glslangValidator",
                                             "GLSL compiler, for vulkan and hlsl",
                                             "install with apt-get install glslang-tools"};
inline constexpr ProgramInfo kGpuProgram{
    "--gpu", "lumaknot-gpu", "GPU helper, for gl, gles, vulkan and hlsl",
    "it is built with this program and kept next to it", "lumaknot-gpu next to this program"};
inline constexpr ProgramInfo kOslProgram{
    "--osl-python", "python", "Python with the bpy module, for osl",
    "get it with scripts/install-extras osl", "the one from scripts/install-extras"};

/// Where the programs are and how long each may run.
struct Programs {
  std::map<std::string_view, std::string> paths;  ///< by ProgramInfo::flag, where not the default
  std::chrono::duration<double> time_limit = std::chrono::seconds(300);

  /// A path or a name to look for on PATH; empty for the program of that place.
  std::string path(const ProgramInfo& program) const {
    const auto given = paths.find(program.flag);
    if (given != paths.end()) return given->second;
    return program.place.empty() ? std::string(program.name) : std::string();
  }
};

/// "povray not found; install with apt-get install povray".
std::string not_found(const Programs& programs, const ProgramInfo& program);

}  // namespace lumaknot::validate
