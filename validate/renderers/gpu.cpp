#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"
#include "validate/renderers/gpu_job.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

/// One way of drawing emitted shaders.
struct Interface {
  std::string_view name;
  Language language;
};

constexpr Interface kGl{"GL", Language::kGlsl330};
constexpr Interface kGles{"GLES", Language::kGlslEs300};
constexpr Interface kVulkan{"Vulkan", Language::kGlsl450};
constexpr Interface kHlsl{"HLSL", Language::kHlsl};

/// lumaknot-gpu, which is built beside this program.
fs::path gpu_program(const Programs& programs) {
  const std::string given = programs.path(kGpuProgram);
  return given.empty() ? program_beside(std::string(kGpuProgram.name)) : find_program(given);
}

/// The shots as jobs: a job has one texture on the axes of a space, so each space baked into has
/// its own; the first job also holds all that read none.
std::vector<std::vector<Shot>> jobs_of(std::span<const Shot> shots) {
  std::vector<std::vector<Shot>> jobs(1);
  std::vector<Space> spaces;
  for (const Shot& shot : shots) {
    std::size_t job = 0;
    if (shot.material.form == Form::kBaked) {
      job = std::size_t(std::ranges::find(spaces, shot.material.space) - spaces.begin());
      if (job == spaces.size()) spaces.push_back(shot.material.space);
    }
    if (job == jobs.size()) jobs.emplace_back();
    jobs[job].push_back(shot);
  }
  return jobs;
}

class Gpu final : public Renderer {
 public:
  Gpu(const Interface& interface, const Programs& programs)
      : interface_(interface), programs_(programs) {}

  std::string name() const override { return std::string(interface_.name); }

  Availability availability() const override {
    const fs::path program = gpu_program(programs_);
    const std::string missing = missing_program(program);
    if (!missing.empty()) return {.found = false, .version = {}, .path = {}, .remedy = missing};
    const PrivateFolder folder;
    const ProcessResult ended =
        run({{program.string(), "--version-of", std::string(backend_of(interface_.language).api)},
             folder.path(),
             {}},
            std::chrono::seconds(30));
    const std::string line = ended.log.substr(0, ended.log.find('\n'));
    if (!ended.succeeded()) {
      return {.found = false, .version = {}, .path = {}, .remedy = line + "; " + remedy()};
    }
    return {.found = true, .version = line, .path = program.string(), .remedy = {}};
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Rendering rendering;
    rendering.renderer = name();
    const Availability here = availability();
    if (!here.found) {
      rendering.shots = undrawn(shots.size(), RenderedShot::Status::kSkipped, here.remedy);
      return rendering;
    }
    rendering.version = here.version;
    std::map<std::string, RenderedShot> drawn;
    for (const std::vector<Shot>& job : jobs_of(shots)) {
      try {
        draw_job(here.path, scene, job, rendering, drawn);
      } catch (const std::runtime_error& e) {
        for (const Shot& shot : job) {
          drawn[shot.name] = undrawn(1, RenderedShot::Status::kFailed, e.what()).front();
        }
      }
    }
    for (const Shot& shot : shots) rendering.shots.push_back(std::move(drawn[shot.name]));
    return rendering;
  }

 private:
  std::string remedy() const {
    return backend_of(interface_.language).api == "vulkan"
               ? "apt-get install mesa-vulkan-drivers"
               : "apt-get install libegl1 libgl1-mesa-dri";
  }

  std::string missing_program(const fs::path& program) const {
    if (program.empty()) return not_found(programs_, kGpuProgram);
    const bool compiles = backend_of(interface_.language).api == "vulkan";
    if (compiles && find_program(programs_.path(kGlslangProgram)).empty()) {
      return not_found(programs_, kGlslangProgram);
    }
    return {};
  }

  void draw_job(const std::string& program, const Scene& scene, const std::vector<Shot>& shots,
                Rendering& rendering, std::map<std::string, RenderedShot>& drawn) const {
    const PrivateFolder folder;
    write_gpu_job(folder.path(), scene, shots, interface_.language, programs_);
    rendering.command = {program, "job.json"};
    const ProcessResult ended = run({rendering.command, folder.path(), {}}, programs_.time_limit);
    rendering.seconds += ended.seconds;
    rendering.log += ended.log;
    if (const std::string bad = bad_end(ended); !bad.empty()) throw std::runtime_error(bad);
    const ImageSpec& size = scene.view.image;
    for (const Shot& shot : shots) {
      drawn[shot.name] = checked_image([&] {
        return read_gpu_image(folder.path() / (shot.name + ".bin"), size.width, size.height);
      });
    }
  }

  Interface interface_;
  Programs programs_;
};

template <const Interface& interface>
std::unique_ptr<Renderer> make(const Programs& programs) {
  return std::make_unique<Gpu>(interface, programs);
}

/// Emitted shaders on a rasteriser as OpenGL and Vulkan allow it.
constexpr Promise kPromise{
    .grid_bits = 8,
    .snaps_shade = true,
    .power_error = 1e-6,
    .texel_weight = 1.0 / 256,
    .unexplained = 0.002,
    .reason =
        "the rasteriser snaps vertices to a grid of 1/256 pixel, and filters textures with "
        "weights of 8 bits; all else is float32. Mesa's llvmpipe interpolates between "
        "vertices that are not snapped, with float32 weights"};

Promise gpu_promise(Promise promise, std::string_view version) {
  if (version.find("llvmpipe") == std::string_view::npos) return promise;
  promise.snaps_shade = false;
  promise.texel_weight = 0;
  promise.sample_roundings = 1;
  return promise;
}

}  // namespace

extern const RendererEntry kGlEntry{.name = kGl.name,
                                    .flag = "gl",
                                    .by_default = true,
                                    .make = make<kGl>,
                                    .programs = {&kGpuProgram},
                                    .promise = kPromise,
                                    .promise_of = gpu_promise};

extern const RendererEntry kGlesEntry{.name = kGles.name,
                                      .flag = "gles",
                                      .make = make<kGles>,
                                      .programs = {&kGpuProgram},
                                      .promise = kPromise,
                                      .promise_of = gpu_promise};

extern const RendererEntry kVulkanEntry{.name = kVulkan.name,
                                        .flag = "vulkan",
                                        .by_default = true,
                                        .make = make<kVulkan>,
                                        .programs = {&kGpuProgram, &kGlslangProgram},
                                        .promise = kPromise,
                                        .promise_of = gpu_promise};

extern const RendererEntry kHlslEntry{.name = kHlsl.name,
                                      .flag = "hlsl",
                                      .make = make<kHlsl>,
                                      .programs = {&kGpuProgram, &kGlslangProgram},
                                      .promise = kPromise,
                                      .promise_of = gpu_promise};

}  // namespace lumaknot::validate
