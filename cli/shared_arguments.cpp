#include "cli/shared_arguments.h"

#include "cli/terminal.h"
#include "scene/presets.h"
#include "validate/renderer.h"

namespace lumaknot {
namespace {

Argument program_argument(std::string names, std::string& target, std::string_view meaning) {
  return {.names = std::move(names),
          .target = &target,
          .meaning = meaning,
          .value = kProgram,
          .heading = "Other programs"};
}

}  // namespace

Argument scene_argument(std::string& scene) {
  Argument argument{.names = "scene",
                    .target = &scene,
                    .meaning = "scene file, built-in scene, or - for standard input",
                    .value = kScene,
                    .checked = false};
  for (const NamedScene& known : named_scenes()) argument.choices.emplace_back(known.name);
  return argument;
}

std::vector<Argument> output_arguments(Output& output) {
  return {{.names = "--quiet", .target = &output.quiet, .meaning = "print nothing but errors"},
          {.names = "--json",
           .target = &output.json,
           .meaning = "print the result as JSON on standard output"}};
}

std::vector<Argument> program_arguments(Programs& programs) {
  std::vector<Argument> all{
      program_argument("--povray", programs.povray, "POV-Ray"),
      program_argument("--blender", programs.blender, "Blender"),
      program_argument("--xvfb", programs.xvfb, "the X server that Eevee draws on"),
      program_argument("--gpu", programs.gpu, "lumaknot-gpu, for gl, gles, vulkan and hlsl"),
      program_argument("--glslang", programs.glslang, "glslangValidator, for vulkan and hlsl"),
      program_argument("--osl-python", programs.osl_python,
                       "a Python with the module bpy, for osl")};
  all[3].default_text = "the one beside this program";
  all[5].default_text = "the one of scripts/install-extras";
  return all;
}

}  // namespace lumaknot
