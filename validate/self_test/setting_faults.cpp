#include "validate/self_test/setting_faults.h"

#include <fmt/format.h>

#include <algorithm>

#include "system/atomic_file.h"

namespace lumaknot::validate {
namespace {

std::vector<SettingFault> all_setting_faults() {
  const auto povray = [](std::string what, std::string edit, std::vector<std::string> names) {
    return SettingFault{"povray",
                        &kPovrayProgram,
                        "*.pov",
                        std::move(edit),
                        {.what = std::move(what), .names = std::move(names)}};
  };
  const auto blender = [](std::string renderer, std::string what, std::string edit,
                          std::vector<std::string> names) {
    return SettingFault{std::move(renderer),
                        &kBlenderProgram,
                        "scene.py",
                        std::move(edit),
                        {.what = std::move(what), .names = std::move(names)}};
  };
  const auto gl = [](std::string what, std::string edit, std::vector<std::string> names) {
    return SettingFault{"gl",
                        &kGpuProgram,
                        "*.fragment",
                        std::move(edit),
                        {.what = std::move(what), .names = std::move(names)}};
  };
  const std::vector<std::string> decoded{"texture-decoded", "texture-decoded-late"};
  const std::string as_srgb = "s/\"Non-Color\"/\"sRGB\"/";
  return {
      povray("POV-Ray's image map read as sRGB", "s/gamma 1.0 interpolate/gamma srgb interpolate/",
             decoded),
      povray("POV-Ray's nearest texel", "s/ interpolate 2//", {"texture-nearest"}),
      blender("cycles", "Cycles' texture read as sRGB", as_srgb, decoded),
      blender("cycles", "Cycles' nearest texel",
              "s/node.interpolation = interpolation/node.interpolation = \"Closest\"/",
              {"texture-nearest"}),
      blender("eevee", "Eevee's texture read as sRGB", as_srgb, decoded),
      gl("the V of GL's texture coordinates flipped",
         "s/surface_uv)/vec2(surface_uv.x, 1.0 - surface_uv.y))/", {"texture-flip-v"}),
      gl("GL's normals inverted", "s/normalize(normal)/normalize(-normal)/", {"normals-inverted"}),
  };
}

/// Alters the files of the private folder that a renderer's program runs in, then runs it. It fails
/// where files are there of which none changes, as the fault would not be planted.
std::string altering_script(const SettingFault& fault, const std::filesystem::path& program) {
  return fmt::format(R"sh(#!/bin/sh
all() {{ find . -type f -name '{}' "$@"; }}
case "$HOME" in "$PWD"*)
  before=$(all -exec cat {{}} + | cksum)
  all -exec sed -i '{}' {{}} +
  if [ -n "$(all)" ] && [ "$before" = "$(all -exec cat {{}} + | cksum)" ]; then
    echo "nothing to alter in {}" >&2
    exit 1
  fi
esac
exec '{}' "$@"
)sh",
                     fault.files, fault.edit, fault.files, program.string());
}

}  // namespace

std::vector<SettingFault> setting_faults(const std::vector<std::string>& renderers) {
  std::vector<SettingFault> all = all_setting_faults();
  std::erase_if(
      all, [&](const SettingFault& f) { return std::ranges::count(renderers, f.renderer) == 0; });
  return all;
}

AlteredProgram::AlteredProgram(const SettingFault& fault, Programs programs)
    : programs_(std::move(programs)) {
  const auto script = folder_.path() / std::string(fault.program->name);
  const std::string given = programs_.path(*fault.program);
  const auto real =
      given.empty() ? program_beside(std::string(fault.program->name)) : find_program(given);
  write_file(script, altering_script(fault, real), "the self-test's folder");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  programs_.paths[fault.program->flag] = script.string();
}

}  // namespace lumaknot::validate
