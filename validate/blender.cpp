#include "exporters/blender.h"

#include <fmt/format.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "validate/blender_run.h"
#include "validate/external.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

/// A private X display, gone with this object.
class Display {
 public:
  explicit Display(const fs::path& xvfb)
      : server_(
            {{xvfb.string(), "-displayfd", "1", "-nolisten", "tcp", "-screen", "0", "640x480x24"},
             folder_.path(),
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
  PrivateFolder folder_;
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
    if (const std::string missing = remedy(); !missing.empty()) {
      rendering.shots = undrawn(shots.size(), RenderedShot::Status::kSkipped, missing);
    } else {
      try {
        rendering = draw_on_display(scene, shots);
      } catch (const std::runtime_error& e) {
        rendering.shots = undrawn(shots.size(), RenderedShot::Status::kFailed, e.what());
      }
    }
    rendering.renderer = name_;
    rendering.limited = engine_ == "eevee" && cuts_negative_colors(rendering.version);
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

  Rendering draw_on_display(const Scene& scene, std::span<const Shot> shots) const {
    BlenderRun blender{.command = blender_command(find_program(programs_.blender), "scene.py"),
                       .environment = {},
                       .engine = engine_,
                       .shaders = ShotShaders::kNodes,
                       .time_limit = programs_.time_limit};
    std::optional<Display> display;
    if (needs_display_) {
      display.emplace(find_program(programs_.xvfb));
      blender.environment = {"DISPLAY=" + display->name(), "LIBGL_ALWAYS_SOFTWARE=1"};
    }
    return draw_in_blender(blender, scene, shots);
  }

  Programs programs_;
  std::string engine_, name_;
  bool needs_display_;
};

}  // namespace

std::unique_ptr<Renderer> cycles_renderer(const Programs& programs) {
  return std::make_unique<Blender>(programs, "cycles", "Cycles", false);
}

std::unique_ptr<Renderer> eevee_renderer(const Programs& programs) {
  return std::make_unique<Blender>(programs, "eevee", "Eevee", true);
}

}  // namespace lumaknot
