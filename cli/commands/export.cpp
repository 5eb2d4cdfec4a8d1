#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "exporters/blender/scene.h"
#include "exporters/gltf/scene.h"
#include "exporters/obj/scene.h"
#include "exporters/povray/scene.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/listing.h"
#include "system/process.h"
#include "validate/renderers/blender_run.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct ExportFlags {
  std::string scene = "figure2", output;
  validate::Programs programs;
  Output out;
};

Shot final_shot(const Scene& scene) { return {"final", Stage::kFinal, scene.view.material}; }

fs::path folder_of(const fs::path& output) {
  return output.has_parent_path() ? output.parent_path() : fs::path(".");
}

/// A scene to export and its source.
struct Job {
  const SceneInput& input;
  const Scene& scene;
  const ExportFlags& flags;
};

std::string stem_of(const Job& job) { return fs::path(job.flags.output).stem().string(); }

void check_no_input_overwritten(const Package& package, const Job& job) {
  for (const PackedFile& file : package) {
    check_not_input(folder_of(job.flags.output) / file.name, job.input, "--output");
  }
}

std::vector<std::string> write(const Job& job, const Package& package) {
  check_no_input_overwritten(package, job);
  write_package(folder_of(job.flags.output), package, "--output");
  std::vector<std::string> names;
  for (const PackedFile& file : package) names.push_back(file.name);
  return names;
}

std::vector<std::string> export_pov(const Job& job) {
  const Package package = povray::pov_package(job.scene, stem_of(job));
  if (const auto shortfall = povray::pov_shortfall(job.scene.view, final_shot(job.scene));
      shortfall && !job.flags.out.quiet) {
    fmt::print(stderr, "lumaknot: note: {}; exported without\n", *shortfall);
  }
  return write(job, package);
}

std::vector<std::string> export_python(const Job& job) {
  const Shot shot = final_shot(job.scene);
  return write(job, blender::blender_package(job.scene, {&shot, 1}, stem_of(job)));
}

std::vector<std::string> export_obj(const Job& job) {
  const Package materials = obj::obj_materials(job.scene, stem_of(job));
  check_no_input_overwritten(materials, job);
  return obj::write_obj_scene(job.flags.output, job.scene.mesh, materials, "--output");
}

/// A self-contained .blend file, written by Blender itself.
std::vector<std::string> export_blend(const Job& job) {
  const ExportFlags& flags = job.flags;
  validate::save_blend(job.scene, final_shot(job.scene), flags.output, flags.programs, "--output");
  return {fs::path(flags.output).filename().string()};
}

/// Writes the package that `make`, glb_package() or gltf_package(), builds from the scene.
template <Package make(const Scene&, const std::string&)>
std::vector<std::string> export_gltf(const Job& job) {
  const Package package = make(job.scene, stem_of(job));
  if (!job.flags.out.quiet) fmt::print(stderr, "lumaknot: note: {}\n", gltf::kGltfShortfall);
  return write(job, package);
}

struct SceneFormat {
  std::string_view ending, remark;
  std::vector<std::string> (*write)(const Job&);
};
constexpr SceneFormat kSceneFormats[] = {
    {".pov", "", export_pov},
    {".py", "Blender script", export_python},
    {".blend", "", export_blend},
    {".glb", "", export_gltf<gltf::glb_package>},
    {".gltf", "", export_gltf<gltf::gltf_package>},
    {".obj", "", export_obj},
};

/// ".pov, .py or .obj": the endings of all formats, described or alone.
std::string scene_endings(bool described) {
  std::vector<std::string> endings;
  for (const SceneFormat& format : kSceneFormats) {
    endings.push_back(described_ending(format.ending, described ? format.remark : ""));
  }
  return listing(endings, "or");
}

const SceneFormat& format_of(const std::string& output) {
  for (const SceneFormat& format : kSceneFormats) {
    if (fs::path(output).extension() == format.ending) return format;
  }
  throw Error(fmt::format("--output {} must end in {}", output, scene_endings(false)));
}

void run(const ExportFlags& flags) {
  const SceneFormat& format = format_of(flags.output);
  check_package_name(flags.output, "--output");
  check_writable(flags.output, "--output");
  const SceneInput input = read_scene(flags.scene);
  check_not_input(flags.output, input, "--output");
  const Scene scene = load_scene(input);
  const std::vector<std::string> files = format.write({input, scene, flags});
  if (flags.out.json) fmt::print("{}\n", nlohmann::ordered_json{{"files", files}}.dump(2));
  for (const std::string& file : files) flags.out.say((folder_of(flags.output) / file).string());
}

std::vector<Argument> export_arguments(ExportFlags& flags) {
  std::vector<Argument> all{scene_argument(flags.scene),
                            {.names = "-o,--output",
                             .target = &flags.output,
                             .meaning = "file to write: " + scene_endings(true),
                             .value = kFile,
                             .required = true}};
  append(all, output_arguments(flags.out));
  append(all, program_arguments(flags.programs));
  return all;
}

}  // namespace

Subcommand export_command() {
  const auto flags = std::make_shared<ExportFlags>();
  return {
      .name = "export",
      .group = Group::kMake,
      .about = "Export a scene to POV-Ray, Blender, glTF or OBJ",
      .arguments = export_arguments(*flags),
      .examples = {{"lumaknot export scene.json -o knot.pov", "also writes its images"},
                   {"lumaknot export scene.json -o knot.py", "also writes its mesh and image"},
                   {"lumaknot export figure2 -o knot.blend", "needs Blender"},
                   {"lumaknot export figure2 -o knot.glb", "glTF 2.0 in a single file"},
                   {"lumaknot export figure2 -o knot.gltf", "also writes its arrays and image"},
                   {"lumaknot export figure2 -o knot.obj", "also writes knot.mtl and its image"}},
      .run = [flags] {
        const InterruptGuard guard;
        run(*flags);
        return kExitAgreed;
      }};
}

}  // namespace lumaknot::cli
