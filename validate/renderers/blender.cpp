#include <fmt/format.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "exporters/blender/scene.h"
#include "validate/renderers/blender_run.h"
#include "validate/renderers/cycles_filter.h"
#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"

namespace lumaknot::validate {
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
  Blender(const Programs& programs, std::string engine, std::string name, bool needs_display,
          std::optional<Sampling> sampling = {})
      : programs_(programs),
        engine_(std::move(engine)),
        name_(std::move(name)),
        needs_display_(needs_display),
        sampling_(sampling) {}

  std::string name() const override { return name_; }

  Availability availability() const override {
    const std::string missing = remedy();
    if (!missing.empty()) return {.found = false, .version = {}, .path = {}, .remedy = missing};
    const fs::path program = find_program(programs_.path(kBlenderProgram));
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
    if (find_program(programs_.path(kBlenderProgram)).empty()) {
      return not_found(programs_, kBlenderProgram);
    }
    if (needs_display_ && find_program(programs_.path(kXvfbProgram)).empty()) {
      return not_found(programs_, kXvfbProgram);
    }
    return {};
  }

  Rendering draw_on_display(const Scene& scene, std::span<const Shot> shots) const {
    BlenderRun blender{
        .command = blender_command(find_program(programs_.path(kBlenderProgram)), "scene.py"),
        .environment = {},
        .engine = engine_,
        .shaders = blender::ShotShaders::kNodes,
        .time_limit = programs_.time_limit,
        .sampling = sampling_};
    std::optional<Display> display;
    if (needs_display_) {
      display.emplace(find_program(programs_.path(kXvfbProgram)));
      blender.environment = {"DISPLAY=" + display->name(), "LIBGL_ALWAYS_SOFTWARE=1"};
    }
    return draw_in_blender(blender, scene, shots);
  }

  Programs programs_;
  std::string engine_, name_;
  bool needs_display_;
  std::optional<Sampling> sampling_;
};

Promise eevee_promise(Promise promise, std::string_view version) {
  // Errors of a whole step were seen: its half floats are cut, not rounded.
  if (cuts_negative_colors(std::string(version))) promise.output_relative = 2 * kStepHalf;
  return promise;
}

std::unique_ptr<Renderer> make_cycles(const Programs& programs) {
  return std::make_unique<Blender>(programs, "cycles", "Cycles", false);
}

std::unique_ptr<Renderer> make_sampling_cycles(const Programs& programs, const Sampling& sampling) {
  return std::make_unique<Blender>(programs, "cycles", "Cycles", false, sampling);
}

constexpr SamplingEntry kCyclesSampling{.make = make_sampling_cycles,
                                        .filter = {cycles_filter, kCyclesReach},
                                        .first_is_centred = true};

std::unique_ptr<Renderer> make_eevee(const Programs& programs) {
  return std::make_unique<Blender>(programs, "eevee", "Eevee", true);
}

}  // namespace

extern const RendererEntry kCyclesEntry{
    .name = "Cycles",
    .flag = "cycles",
    .by_default = true,
    .make = make_cycles,
    .programs = {&kBlenderProgram},
    .promise = {.power_error = 1e-6,
                .texture_step = kStep16,
                .reason = "float32 throughout: positions, normals and texture coordinates are "
                          "rounded four times, a sample's place in the image twice"},
    .sampling = &kCyclesSampling};

extern const RendererEntry kEeveeEntry{
    .name = "Eevee",
    .flag = "eevee",
    .by_default = true,
    .make = make_eevee,
    .programs = {&kBlenderProgram, &kXvfbProgram},
    .promise = {.grid_bits = 8,
                .sample_roundings = 1.5,
                .power_error = 1e-6,
                .texture_step = kStep16,
                .unexplained = 0.01,
                .reason = "float32 as in Cycles; the OpenGL rasteriser snaps vertices to a grid of "
                          "1/256 pixel, which moves edges, and its depth buffer has steps: 1 % of "
                          "the silhouette; half-float buffers from 4.2 on. The texture is fetched "
                          "texel by texel, since its own filter always takes mipmaps"},
    .promise_of = eevee_promise};

}  // namespace lumaknot::validate
