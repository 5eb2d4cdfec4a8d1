#include <fmt/format.h>

#include <cstdlib>

#include "validate/renderers/blender_run.h"
#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVersionScript =
    "import bpy, _cycles\n"
    "assert _cycles.with_osl, 'its Blender is built without OSL'\n"
    "print('bpy', bpy.app.version_string)\n";

/// Where scripts/install-extras puts its Python.
std::string usual_python() {
  const auto value = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string(text ? text : "");
  };
  const std::string cache = value("XDG_CACHE_HOME");
  return (cache.empty() ? value("HOME") + "/.cache" : cache) + "/lumaknot/osl/bin/python";
}

/// Cycles of a Python that has the module bpy.
class Osl final : public Renderer {
 public:
  explicit Osl(const Programs& programs)
      : programs_(programs),
        python_(programs.path(kOslProgram).empty() ? usual_python() : programs.path(kOslProgram)) {}

  std::string name() const override { return "OSL"; }

  Availability availability() const override {
    const fs::path program = find_program(python_);
    if (program.empty()) return missing(python_ + " not found");
    try {
      const PrivateFolder folder;
      const ProcessResult ended = run({{program.string(), "-c", kVersionScript}, folder.path(), {}},
                                      std::chrono::seconds(60));
      if (!ended.succeeded()) return missing(fmt::format("{} {}", python_, bad_end(ended)));
      return {.found = true,
              .version = line_with(ended.log, "bpy "),
              .path = program.string(),
              .remedy = {}};
    } catch (const std::runtime_error& e) {
      return missing(e.what());
    }
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Rendering rendering;
    if (const Availability here = availability(); !here.found) {
      rendering.shots = undrawn(shots.size(), RenderedShot::Status::kSkipped, here.remedy);
    } else {
      try {
        rendering = draw_in_blender(blender(here.path), scene, shots);
        rendering.version = here.version;
      } catch (const std::runtime_error& e) {
        rendering.shots = undrawn(shots.size(), RenderedShot::Status::kFailed, e.what());
      }
    }
    rendering.renderer = name();
    return rendering;
  }

 private:
  static Availability missing(const std::string& why) {
    return {
        .found = false, .version = {}, .path = {}, .remedy = why + "; scripts/install-extras osl"};
  }

  BlenderRun blender(const std::string& program) const {
    return {.command = {program, "scene.py", "--"},
            .environment = {},
            .engine = "cycles",
            .shaders = blender::ShotShaders::kOsl,
            .time_limit = programs_.time_limit};
  }

  Programs programs_;
  std::string python_;
};

std::unique_ptr<Renderer> make_osl(const Programs& programs) {
  return std::make_unique<Osl>(programs);
}

}  // namespace

/// The emitted OSL in Cycles of the Python module bpy: Debian's Blender is built without OSL.
extern const RendererEntry kOslEntry{
    .name = "OSL",
    .flag = "osl",
    .make = make_osl,
    .programs = {&kOslProgram},
    .promise = {.power_error = 1.4e-5,
                .texture_step = kStep16,
                .reason = "as in Cycles, float32; and the fast pow of OSL's library errs by 1.4e-5 "
                          "+ 1.8e-7 times the exponent of its value"}};

}  // namespace lumaknot::validate
