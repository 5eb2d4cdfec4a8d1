#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shader_job.h"
#include "cli/commands/shader_list.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "exporters/blender/scene.h"
#include "exporters/image/baked_texture.h"
#include "exporters/image/file.h"
#include "exporters/package.h"
#include "scene/presets.h"
#include "shaders/languages/emit.h"
#include "system/error.h"
#include "system/known.h"
#include "system/process.h"
#include "validate/renderers/spirv.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct ShaderFlags {
  NamedFormula formula;
  std::string scene, output = ".", name;
  std::vector<std::string> languages{"all"};
  bool list = false, all_parameters = false;
  validate::Programs programs;
  Output out;
};

/// The requested languages that can express the job. "all" skips the others and reports why.
std::vector<Language> languages_of(const ShaderFlags& flags, const ShaderJob& job) {
  std::vector<Language> chosen;
  const bool all = std::ranges::count(flags.languages, "all") > 0;
  for (const Language language : languages()) {
    if (!all && std::ranges::count(flags.languages, backend_of(language).name) == 0) continue;
    const auto why = emission_shortfall(job, language);
    if (why && !all) throw Error(*why);
    if (!why) chosen.push_back(language);
    if (why && !flags.out.quiet) fmt::print(stderr, "lumaknot: note: {}; skipped\n", *why);
  }
  return chosen;
}

Package package_of(const ShaderJob& job, Language language) {
  Package package;
  for (const EmittedFile& file : emit(job, language)) package.push_back({file.name, file.text});
  if (language == Language::kBlender) {
    package.push_back({"lumaknot_nodes.py", std::string(blender::blender_nodes_loader())});
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
  nlohmann::ordered_json json{{"language", backend_of(written.language).name},
                              {"folder", written.folder.string()},
                              {"files", written.files}};
  if (written.instructions) json["spirv_instructions"] = *written.instructions;
  return json;
}

std::string written_line(const Written& written) {
  std::string line = fmt::format("{:<12}", backend_of(written.language).name);
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
  throw Error(fmt::format("--output {} can't be used as a folder: {}; choose another place",
                          folder.string(), error.message()));
}

/// Each of several languages gets its own folder, as they share file names.
std::vector<Written> write_all(const ShaderFlags& flags, const ShaderJob& job,
                               const Package& images, const SceneInput& input) {
  std::vector<std::pair<Language, Package>> packages;
  for (const Language language : languages_of(flags, job)) {
    packages.emplace_back(language, package_of(job, language));
    std::ranges::copy(images, std::back_inserter(packages.back().second));
  }
  const auto folder_of = [&](Language language) {
    const fs::path folder = flags.output;
    return packages.size() > 1 ? folder / backend_of(language).name : folder;
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
      written.instructions = validate::fragment_instructions(flags.programs, job, language);
    }
    all.push_back(std::move(written));
  }
  return all;
}

/// Compares the instructions of a formula in YIQ with the paper's Table 1, emitted the same way.
void say_table1(const ShaderFlags& flags, const ShaderJob& job, const std::vector<Written>& all) {
  const Material& m = job.shot.material;
  if (m.space != Space::kYiq || m.rate != ShadingFrequency::kPixel) return;
  ShaderJob table1;
  table1.name = "yiq-table1-phong";
  table1.shot = {"final", Stage::kFinal, known(with_formula(table1.view.material, table1.name))};
  for (const Written& written : all) {
    if (!written.instructions) continue;
    flags.out.say(fmt::format(
        "{}: {} SPIR-V instructions; the paper's Table 1, emitted the same way: {}",
        backend_of(written.language).name, *written.instructions,
        known(validate::fragment_instructions(flags.programs, table1, written.language))));
  }
}

void emit_all(const ShaderFlags& flags) {
  ShaderJob job;
  Package images;
  SceneInput input;
  if (flags.scene.empty()) {
    job = job_of_formula(flags.formula);
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
  check_shader_name(job.name);
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
  if (flags.list || (flags.formula.shader.empty() && flags.scene.empty())) {
    fmt::print("{}", flags.out.json ? shader_list_json() : shader_list_text());
    return;
  }
  if (!flags.formula.shader.empty() && !flags.scene.empty()) {
    throw Error("give a shader's name or --scene, not both");
  }
  emit_all(flags);
}

std::vector<std::string> language_names() {
  std::vector<std::string> names{"all"};
  for (const Language language : languages()) names.emplace_back(backend_of(language).name);
  return names;
}

std::vector<Argument> shader_arguments(ShaderFlags& flags) {
  std::vector<Argument> all{
      {.names = "shader",
       .target = &flags.formula.shader,
       .meaning = "space and model, as in yiq-phong; if omitted, all shaders are listed",
       .value = "SHADER",
       .choices = formula_names(),
       .checked = false},
      {.names = "--scene",
       .target = &flags.scene,
       .meaning = "emit the shader of this scene, with only what it needs",
       .value = kScene,
       .choices = scene_argument(flags.scene).choices,
       .checked = false},
      {.names = "--lang",
       .target = &flags.languages,
       .meaning = "languages to emit",
       .choices = language_names(),
       .list = true,
       .greedy = true},
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "folder to write to",
       .value = kFolder},
      {.names = "--name", .target = &flags.name, .meaning = "name of the shader and its files"},
      {.names = "--list",
       .target = &flags.list,
       .meaning = "list the shaders and the languages that can express them"},
      program_argument(flags.programs, validate::kGlslangProgram)};
  all.back().meaning = "GLSL compiler, to count instructions";
  all.back().heading = {};
  append(all, output_arguments(flags.out));
  append(all, formula_arguments(flags.formula));
  all.push_back({.names = "--all-parameters",
                 .target = &flags.all_parameters,
                 .meaning = "keep every number as a parameter, even if it is 0 or 1",
                 .heading = "Formula"});
  return all;
}

}  // namespace

Subcommand shader_command() {
  const auto flags = std::make_shared<ShaderFlags>();
  return {.name = "shader",
          .group = Group::kMake,
          .about = "Emit a lighting formula as a GLSL, HLSL, OSL, Blender or POV-Ray shader",
          .arguments = shader_arguments(*flags),
          .examples = {{"lumaknot shader --list"},
                       {"lumaknot shader yiq-phong --lang glsl-330 -o out/"},
                       {"lumaknot shader cielab-cook-torrance --lang hlsl,osl --light spot"},
                       {"lumaknot shader --scene scene.json --lang all -o out/"}},
          .run = [flags] {
            const InterruptGuard guard;
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
