#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/shader_list.h"
#include "cli/terminal.h"
#include "exporters/baked_texture.h"
#include "exporters/blender.h"
#include "exporters/image_file.h"
#include "exporters/package.h"
#include "scene/error.h"
#include "scene/fields.h"
#include "scene/presets.h"
#include "shaders/emit.h"
#include "validate/process.h"
#include "validate/spirv.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

struct ShaderFlags {
  std::string shader, scene, output = ".", name, rate = "pixel", gamut = "free";
  std::vector<std::string> languages{"all"}, lights;
  bool list = false, gated = false, all_parameters = false;
  Programs programs;
  Output out;
};

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

ShaderJob job_of_name(const ShaderFlags& flags) {
  ShaderJob job;
  const std::optional<Material> material = with_formula(job.view.material, flags.shader);
  if (!material) {
    throw Error(fmt::format(
        "shader {} is not known; give a space ({}) and a model ({}), as in yiq-phong; all: --list",
        flags.shader, fmt::join(space_use_names(), ", "), fmt::join(kModelNames, ", ")));
  }
  job.name = flags.shader;
  job.shot = {"final", Stage::kFinal, *material};
  Material& m = job.shot.material;
  m.rate = chosen<Rate>(kRateNames, flags.rate);
  m.gamut = chosen<Gamut>(kGamutNames, flags.gamut);
  if (flags.gated) m.highlights = Highlights::kGated;
  if (flags.lights.empty()) return job;
  job.view.lights.clear();
  for (const std::string& light : flags.lights) job.view.lights.push_back(light_of(light));
  return job;
}

/// A file name's stem as a shader's name.
std::string name_of_scene(const std::string& source) {
  std::string name = source == "-" ? "scene" : fs::path(source).stem().string();
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    c = byte < 0x80 && std::isalnum(byte) ? char(std::tolower(byte)) : '-';
  }
  return name;
}

/// A scene's shader: only what the scene needs.
ShaderJob job_of_scene(const SceneSpec& spec, const std::string& source) {
  ShaderJob job;
  job.view = spec.view;
  job.shot = {"final", Stage::kFinal, spec.view.material};
  job.name = name_of_scene(source);
  if (const auto* color = std::get_if<PlainColor>(&spec.texture)) job.color = color->rgb;
  return job;
}

void check_name(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::ranges::all_of(name, plain)) return;
  throw Error(fmt::format(
      "the shader's name must be a letter, then lower-case letters, digits and -, got {}; choose "
      "one with --name",
      name));
}

/// The languages asked for that can express the job. "all" leaves the others out and tells why.
std::vector<Language> languages_of(const ShaderFlags& flags, const ShaderJob& job) {
  std::vector<Language> languages;
  const bool all = std::ranges::count(flags.languages, "all") > 0;
  for (const LanguageInfo& info : kLanguages) {
    if (!all && std::ranges::count(flags.languages, info.name) == 0) continue;
    const auto why = emission_shortfall(job, info.language);
    if (why && !all) throw Error(*why);
    if (!why) languages.push_back(info.language);
    if (why && !flags.out.quiet) fmt::print(stderr, "lumaknot: note: {}; left out\n", *why);
  }
  return languages;
}

Package package_of(const ShaderJob& job, Language language) {
  Package package;
  for (const EmittedFile& file : emit(job, language)) package.push_back({file.name, file.text});
  if (language == Language::kBlender) {
    package.push_back({"lumaknot_nodes.py", std::string(blender_nodes_loader())});
  }
  return package;
}

/// A shader that was written.
struct Written {
  Language language;
  fs::path folder;
  std::vector<std::string> files;
  std::optional<int> instructions;  ///< of the fragment stage, in SPIR-V
};

nlohmann::ordered_json written_json(const Written& written) {
  nlohmann::ordered_json json{{"language", info_of(written.language).name},
                              {"folder", written.folder.string()},
                              {"files", written.files}};
  if (written.instructions) json["spirv_instructions"] = *written.instructions;
  return json;
}

std::string written_line(const Written& written) {
  std::string line = fmt::format("{:<12}", info_of(written.language).name);
  for (const std::string& file : written.files)
    line += fmt::format(" {}", (written.folder / file).string());
  if (written.instructions)
    line += fmt::format("  ({} SPIR-V instructions)", *written.instructions);
  return line;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder)) return;
  throw Error(fmt::format("--output {} can't be made a folder: {}; choose another place",
                          folder.string(), error.message()));
}

/// Each language in a folder of its own where there are several: they share file names.
std::vector<Written> write_all(const ShaderFlags& flags, const ShaderJob& job,
                               const Package& images, const SceneInput& input) {
  std::vector<std::pair<Language, Package>> packages;
  for (const Language language : languages_of(flags, job)) {
    packages.emplace_back(language, package_of(job, language));
    std::ranges::copy(images, std::back_inserter(packages.back().second));
  }
  const auto folder_of = [&](Language language) {
    const fs::path folder = flags.output;
    return packages.size() > 1 ? folder / info_of(language).name : folder;
  };
  for (const auto& [language, package] : packages) {
    for (const PackedFile& file : package) {
      check_not_input(folder_of(language) / file.name, input, "--output");
    }
  }
  std::vector<Written> all;
  for (const auto& [language, package] : packages) {
    Written written{language, folder_of(language), {}, {}};
    make_folder(written.folder);
    write_package(written.folder, package, "--output");
    for (const PackedFile& file : package) written.files.push_back(file.name);
    if (!flags.out.quiet || flags.out.json) {
      written.instructions = fragment_instructions(flags.programs, job, language);
    }
    all.push_back(std::move(written));
  }
  return all;
}

/// The instructions of the paper's Table 1, emitted the same way, beside another formula in YIQ.
void say_table1(const ShaderFlags& flags, const ShaderJob& job, const std::vector<Written>& all) {
  const Material& m = job.shot.material;
  if (m.space != Space::kYiq || m.rate != Rate::kPixel) return;
  ShaderJob table1;
  table1.name = "yiq-table1-phong";
  table1.shot = {"final", Stage::kFinal, *with_formula(table1.view.material, table1.name)};
  for (const Written& written : all) {
    if (!written.instructions) continue;
    flags.out.say(
        fmt::format("{}: {} SPIR-V instructions; the paper's Table 1, emitted likewise: {}",
                    info_of(written.language).name, *written.instructions,
                    *fragment_instructions(flags.programs, table1, written.language)));
  }
}

void emit_all(const ShaderFlags& flags) {
  ShaderJob job;
  Package images;
  SceneInput input;
  if (flags.scene.empty()) {
    job = job_of_name(flags);
  } else {
    input = read_scene(flags.scene);
    job = job_of_scene(input.spec, flags.scene);
    if (job.shot.material.form == Form::kBaked && !job.color) {
      const Texture texture = load_texture(input);
      images.push_back({"axes.exr", texture_exr(baked_texture(std::get<TextureImage>(texture),
                                                              job.shot.material))});
    }
  }
  if (!flags.name.empty()) job.name = flags.name;
  check_name(job.name);
  if (flags.all_parameters) job.keep = Keep::kAll;
  const std::vector<Written> all = write_all(flags, job, images, input);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Written& written : all) {
    json.push_back(written_json(written));
    flags.out.say(written_line(written));
  }
  if (flags.out.json) fmt::print("{}\n", json.dump(2));
  say_table1(flags, job, all);
}

void run(const ShaderFlags& flags) {
  if (flags.list || (flags.shader.empty() && flags.scene.empty())) {
    fmt::print("{}", flags.out.json ? shader_list_json() : shader_list_text());
    return;
  }
  if (!flags.shader.empty() && !flags.scene.empty()) {
    throw Error("give a shader's name or --scene, not both");
  }
  emit_all(flags);
}

std::vector<std::string> language_names() {
  std::vector<std::string> names{"all"};
  for (const LanguageInfo& info : kLanguages) names.emplace_back(info.name);
  return names;
}

}  // namespace

void add_shader_command(CLI::App& program) {
  auto flags = std::make_shared<ShaderFlags>();
  CLI::App* command =
      program.add_subcommand("shader", "Emit a lighting formula as a shader in other languages");
  command->add_option("shader", flags->shader, "a space and a model: yiq-phong; see --list");
  command->add_option("--scene", flags->scene,
                      "the shader of this scene, with nothing that the scene does not need");
  command->add_option("--lang", flags->languages, "languages, or all")
      ->delimiter(',')
      ->check(CLI::IsMember(language_names()))
      ->capture_default_str();
  command->add_option("-o,--output", flags->output, "the folder to write to")
      ->capture_default_str();
  command->add_option("--name", flags->name, "of the shader and its files");
  command->add_option("--light", flags->lights, "point, directional or spot; may be repeated")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(strings(kLightNames)));
  command->add_option("--rate", flags->rate, "where light is computed: pixel or vertex")
      ->check(CLI::IsMember(strings(kRateNames)))
      ->capture_default_str();
  command->add_option("--gamut", flags->gamut, "colours outside [0, 1]: free, clamp or chroma")
      ->check(CLI::IsMember(strings(kGamutNames)))
      ->capture_default_str();
  command->add_flag("--gated", flags->gated, "no highlights where the light is behind");
  command->add_flag("--all-parameters", flags->all_parameters,
                    "keep every number as a parameter, also those that are 0 or 1");
  command->add_flag("--list", flags->list, "what each language can express");
  command
      ->add_option("--glslang", flags->programs.glslang, "glslangValidator, to count instructions")
      ->capture_default_str();
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot shader --list\n"
      "  lumaknot shader yiq-phong --lang glsl-330 -o out/\n"
      "  lumaknot shader cielab-cook-torrance --lang hlsl,osl --light spot -o out/\n"
      "  lumaknot shader --scene scene.json --lang all -o out/");
  command->callback([flags] {
    const InterruptGuard guard;
    run(*flags);
  });
}

}  // namespace lumaknot
