#include "cli/commands/shader_job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "scene/fields.h"
#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kLightNames{"point", "directional", "spot"};

template <std::size_t N>
std::vector<std::string> strings(const std::array<std::string_view, N>& names) {
  return {names.begin(), names.end()};
}

template <class Enum, std::size_t N>
Enum chosen(const std::array<std::string_view, N>& names, std::string_view name) {
  return Enum(std::ranges::find(names, name) - names.begin());
}

Light light_of(std::string_view name) {
  if (name == "directional") return DirectionalLight{.direction = {1.5, 3.0, -3.5}, .color = {}};
  if (name == "spot") return SpotLight{};
  return PointLight{};
}

/// A shader name built from the stem of a file name.
std::string name_of_scene(const std::string& source) {
  std::string name = source == "-" ? "scene" : fs::path(source).stem().string();
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    c = byte < 0x80 && std::isalnum(byte) ? char(std::tolower(byte)) : '-';
  }
  return name;
}

}  // namespace

std::vector<Argument> formula_arguments(NamedFormula& formula) {
  return {{.names = "--light",
           .target = &formula.lights,
           .meaning = "kind of light",
           .default_text = "point",
           .choices = strings(kLightNames),
           .heading = "Formula"},
          {.names = "--rate",
           .target = &formula.rate,
           .meaning = "compute light per pixel or per vertex",
           .choices = strings(kFrequencyNames),
           .heading = "Formula"},
          {.names = "--gamut",
           .target = &formula.gamut,
           .meaning = "handling of colours outside [0, 1]",
           .choices = strings(kGamutNames),
           .heading = "Formula"},
          {.names = "--gated",
           .target = &formula.gated,
           .meaning = "suppress highlights where the light is behind the surface",
           .heading = "Formula"}};
}

ShaderJob job_of_formula(const NamedFormula& formula) {
  ShaderJob job;
  const std::optional<Material> material = with_formula(job.view.material, formula.shader);
  if (!material) {
    throw Error(fmt::format(
        "unknown shader {}; give a space ({}) and a model ({}), as in yiq-phong; --list shows all",
        formula.shader, fmt::join(space_use_names(), ", "), fmt::join(kModelNames, ", ")));
  }
  job.name = formula.shader;
  job.shot = {"final", Stage::kFinal, *material};
  Material& m = job.shot.material;
  m.rate = chosen<ShadingFrequency>(kFrequencyNames, formula.rate);
  m.gamut = chosen<Gamut>(kGamutNames, formula.gamut);
  if (formula.gated) m.highlights = Highlights::kGated;
  if (formula.lights.empty()) return job;
  job.view.lights.clear();
  for (const std::string& light : formula.lights) job.view.lights.push_back(light_of(light));
  return job;
}

ShaderJob job_of_scene(const SceneSpec& spec, const std::string& source) {
  ShaderJob job;
  job.view = spec.view;
  job.shot = {"final", Stage::kFinal, spec.view.material};
  job.name = name_of_scene(source);
  if (const auto* color = std::get_if<PlainColor>(&spec.texture)) job.color = color->rgb;
  return job;
}

void check_shader_name(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::ranges::all_of(name, plain)) return;
  throw Error(fmt::format(
      "the shader's name must start with a letter and hold only lower-case letters, digits and -, "
      "got {}; set it with --name",
      name));
}

}  // namespace lumaknot::cli
