#include "validate/renderers/blender_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "shaders/languages/backend.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "validate/renderers/external.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> drawing_command(const BlenderRun& blender, std::span<const Shot> shots) {
  std::vector<std::string> command = blender.command;
  command.insert(command.end(), {"--engine", blender.engine});
  if (blender.sampling) {
    command.insert(command.end(), {"--samples", std::to_string(blender.sampling->samples), "--seed",
                                   std::to_string(blender.sampling->seed)});
    if (blender.sampling->denoised) command.emplace_back("--denoise");
  }
  for (const Shot& shot : shots) {
    command.insert(command.end(), {"--render", fmt::format("{0}={0}.exr", shot.name)});
  }
  return command;
}

/// The shot's picture, unless the OSL compiler told an error.
RenderedShot drawn_shot(const fs::path& folder, const View& view, const Shot& shot,
                        const ProcessResult& ended) {
  const std::string bad = bad_end(ended);
  if (!bad.empty()) return undrawn(1, RenderedShot::Status::kFailed, bad).front();
  const std::string error = line_with(ended.log, fmt::format("ERROR: scene.{}.osl:", shot.name));
  if (!error.empty()) return undrawn(1, RenderedShot::Status::kFailed, error).front();
  return drawn_image(folder / (shot.name + ".exr"), view);
}

}  // namespace

Rendering draw_package(const BlenderRun& blender, const Package& package, const View& view,
                       std::span<const Shot> shots) {
  const PrivateFolder folder;
  write_package(folder.path(), package, "Blender's folder");
  Rendering rendering;
  rendering.command = drawing_command(blender, shots);
  const ProcessResult ended =
      run({rendering.command, folder.path(), blender.environment}, blender.time_limit);
  rendering.seconds = ended.seconds;
  rendering.log = ended.log;
  rendering.version = line_with(ended.log, "Blender ");
  for (const Shot& shot : shots) {
    rendering.shots.push_back(drawn_shot(folder.path(), view, shot, ended));
  }
  return rendering;
}

Rendering draw_in_blender(const BlenderRun& blender, const Scene& scene,
                          std::span<const Shot> shots) {
  const bool is_osl = blender.shaders == blender::ShotShaders::kOsl;
  const auto shortfall = [&](const Shot& shot) {
    return language_shortfall(is_osl ? Language::kOsl : Language::kBlender, shot.material);
  };
  std::vector<Shot> possible(shots.begin(), shots.end());
  std::erase_if(possible, shortfall);
  Rendering rendering;
  if (!possible.empty()) {
    const Package package = blender::blender_package(scene, possible, "scene", blender.shaders);
    rendering = draw_package(blender, package, scene.view, possible);
  }
  std::vector<RenderedShot> all;
  auto drawn = rendering.shots.begin();
  for (const Shot& shot : shots) {
    const auto why = shortfall(shot);
    all.push_back(why ? undrawn(1, RenderedShot::Status::kSkipped, *why).front()
                      : std::move(*drawn++));
  }
  rendering.shots = std::move(all);
  return rendering;
}

std::vector<std::string> blender_command(const fs::path& program, const std::string& script) {
  return {program.string(),
          "-b",
          "--factory-startup",
          "--disable-autoexec",
          "--python-exit-code",
          "7",
          "--python",
          script,
          "--"};
}

void save_blend(const Scene& scene, const Shot& shot, const fs::path& path,
                const Programs& programs, std::string_view flag) {
  const fs::path program = find_program(programs.path(kBlenderProgram));
  if (program.empty()) {
    throw Error(fmt::format("{} {} needs Blender: {}, or export a .py", flag, path.string(),
                            not_found(programs, kBlenderProgram)));
  }
  const PrivateFolder folder;
  write_package(folder.path(), blender::blender_package(scene, {&shot, 1}, "scene"),
                "Blender's folder");
  std::vector<std::string> command = blender_command(program, "scene.py");
  command.insert(command.end(), {"--save", "scene.blend"});
  const ProcessResult ended = run({command, folder.path(), {}}, programs.time_limit);
  if (!ended.succeeded()) {
    throw Error(fmt::format("{} {}: Blender {}", flag, path.string(), bad_end(ended)));
  }
  write_file(path, read_file(folder.path() / "scene.blend", "Blender's file"), flag);
}

}  // namespace lumaknot::validate
