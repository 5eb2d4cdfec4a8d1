#include "exporters/blender.h"

#include <fmt/format.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "scene/atomic_file.h"
#include "scene/error.h"
#include "validate/blender_run.h"
#include "validate/external.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

/// A private X display, gone with this object.
class Display {
 public:
  Display(const fs::path& xvfb, const fs::path& folder)
      : server_(
            {{xvfb.string(), "-displayfd", "1", "-nolisten", "tcp", "-screen", "0", "640x480x24"},
             folder,
             {}}) {
    // The server prints its display's number when it is ready.
    for (int tries = 0; tries < 200 && server_.running(); ++tries) {
      const std::string log = server_.log();
      const std::size_t digit = log.find_first_of("0123456789");
      if (log.ends_with('\n') && digit != std::string::npos) {
        name_ = fmt::format(":{}", log.substr(digit, log.find('\n', digit) - digit));
        return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    throw std::runtime_error("Xvfb did not start: " + server_.log());
  }

  /// ":7" or the like.
  const std::string& name() const { return name_; }

 private:
  Process server_;
  std::string name_;
};

/// Eevee was written anew in Blender 4.2, and since then makes negative colours black. `version`
/// reads "Blender 4.2.0" or the like.
bool cuts_negative_colors(const std::string& version) {
  int major = 0, minor = 0;
  return std::sscanf(version.c_str(), "Blender %d.%d", &major, &minor) == 2 &&
         std::pair(major, minor) >= std::pair(4, 2);
}

class Blender final : public Renderer {
 public:
  Blender(const Programs& programs, std::string engine, std::string name, bool needs_display)
      : programs_(programs),
        engine_(std::move(engine)),
        name_(std::move(name)),
        needs_display_(needs_display) {}

  std::string name() const override { return name_; }

  Availability availability() const override {
    const std::string missing = remedy();
    if (!missing.empty()) return {.found = false, .version = {}, .path = {}, .remedy = missing};
    const fs::path program = find_program(programs_.blender);
    return {.found = true,
            .version = version_of(program, "--version", "Blender"),
            .path = program.string(),
            .remedy = {}};
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Rendering rendering;
    rendering.renderer = name_;
    if (const std::string missing = remedy(); !missing.empty()) {
      rendering.shots = undrawn(shots.size(), Drawn::Status::kSkipped, missing);
      return rendering;
    }
    try {
      draw_in_folder(scene, shots, rendering);
    } catch (const std::runtime_error& e) {
      rendering.shots = undrawn(shots.size(), Drawn::Status::kFailed, e.what());
    }
    return rendering;
  }

 private:
  /// How to get what is missing; empty when all is here.
  std::string remedy() const {
    if (find_program(programs_.blender).empty()) {
      return fmt::format("{} is not here; apt-get install blender", programs_.blender);
    }
    if (needs_display_ && find_program(programs_.xvfb).empty()) {
      return fmt::format("{} is not here; apt-get install xvfb", programs_.xvfb);
    }
    return {};
  }

  void draw_in_folder(const Scene& scene, std::span<const Shot> shots, Rendering& rendering) const {
    const PrivateFolder folder;
    write_package(folder.path(), blender_package(scene, shots, "scene"), "Blender's folder");
    std::vector<std::string> script_arguments{"--engine", engine_};
    for (const Shot& shot : shots) {
      script_arguments.push_back("--render");
      script_arguments.push_back(fmt::format("{0}={0}.exr", shot.name));
    }
    rendering.command =
        blender_command(find_program(programs_.blender), "scene.py", script_arguments);
    std::optional<Display> display;
    std::vector<std::string> environment;
    if (needs_display_) {
      display.emplace(find_program(programs_.xvfb), folder.path());
      environment = {"DISPLAY=" + display->name(), "LIBGL_ALWAYS_SOFTWARE=1"};
    }
    const Ended ended = run({rendering.command, folder.path(), environment}, programs_.time_limit);
    rendering.seconds = ended.seconds;
    rendering.log = ended.log;
    rendering.version = line_with(ended.log, "Blender ");
    rendering.limited = engine_ == "eevee" && cuts_negative_colors(rendering.version);
    const std::string bad = bad_end(ended);
    for (const Shot& shot : shots) {
      rendering.shots.push_back(bad.empty()
                                    ? drawn_image(folder.path() / (shot.name + ".exr"), scene.view)
                                    : undrawn(1, Drawn::Status::kFailed, bad).front());
    }
  }

  Programs programs_;
  std::string engine_, name_;
  bool needs_display_;
};

}  // namespace

std::vector<std::string> blender_command(const fs::path& program, const std::string& script,
                                         const std::vector<std::string>& script_arguments) {
  std::vector<std::string> command{program.string(),
                                   "-b",
                                   "--factory-startup",
                                   "--disable-autoexec",
                                   "--python-exit-code",
                                   "7",
                                   "--python",
                                   script,
                                   "--"};
  command.insert(command.end(), script_arguments.begin(), script_arguments.end());
  return command;
}

void save_blend(const Scene& scene, const Shot& shot, const fs::path& path,
                const Programs& programs, std::string_view flag) {
  const fs::path program = find_program(programs.blender);
  if (program.empty()) {
    throw Error(
        fmt::format("{} {} needs Blender, and {} is not here; apt-get install blender, or "
                    "export a .py",
                    flag, path.string(), programs.blender));
  }
  const PrivateFolder folder;
  write_package(folder.path(), blender_package(scene, {&shot, 1}, "scene"), "Blender's folder");
  const Ended ended =
      run({blender_command(program, "scene.py", {"--save", "scene.blend"}), folder.path(), {}},
          programs.time_limit);
  if (!ended.well()) {
    throw Error(fmt::format("{} {}: Blender {}", flag, path.string(), bad_end(ended)));
  }
  write_file(path, read_file(folder.path() / "scene.blend", "Blender's file"), flag);
}

std::unique_ptr<Renderer> cycles_renderer(const Programs& programs) {
  return std::make_unique<Blender>(programs, "cycles", "Cycles", false);
}

std::unique_ptr<Renderer> eevee_renderer(const Programs& programs) {
  return std::make_unique<Blender>(programs, "eevee", "Eevee", true);
}

}  // namespace lumaknot
