#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "validate/external.h"
#include "validate/gpu_job.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

/// One way of drawing emitted shaders.
struct Interface {
  std::string_view name, api;
  Language language;
};

constexpr Interface kGl{"GL", "gl", Language::kGlsl330};
constexpr Interface kGles{"GLES", "gles", Language::kGlslEs300};
constexpr Interface kVulkan{"Vulkan", "vulkan", Language::kGlsl450};
constexpr Interface kHlsl{"HLSL", "vulkan", Language::kHlsl};

/// lumaknot-gpu, which is built beside this program.
fs::path gpu_program(const Programs& programs) {
  return programs.gpu.empty() ? program_beside("lumaknot-gpu") : find_program(programs.gpu);
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
    const Ended ended =
        run({{program.string(), "--version-of", std::string(interface_.api)}, folder.path(), {}},
            std::chrono::seconds(30));
    const std::string line = ended.log.substr(0, ended.log.find('\n'));
    if (!ended.well()) {
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
    return interface_.api == "vulkan" ? "apt-get install mesa-vulkan-drivers"
                                      : "apt-get install libegl1 libgl1-mesa-dri";
  }

  std::string missing_program(const fs::path& program) const {
    if (program.empty())
      return fmt::format("{} is not here; it is built with this program and lies beside it",
                         programs_.gpu.empty() ? "lumaknot-gpu" : programs_.gpu);
    const bool compiles = interface_.api == "vulkan";
    if (compiles && find_program(programs_.glslang).empty()) {
      return fmt::format("{} is not here; apt-get install glslang-tools", programs_.glslang);
    }
    return {};
  }

  void draw_job(const std::string& program, const Scene& scene, const std::vector<Shot>& shots,
                Rendering& rendering, std::map<std::string, RenderedShot>& drawn) const {
    const PrivateFolder folder;
    write_gpu_job(folder.path(), scene, shots, interface_.language, programs_);
    rendering.command = {program, "job.json"};
    const Ended ended = run({rendering.command, folder.path(), {}}, programs_.time_limit);
    rendering.seconds += ended.seconds;
    rendering.log += ended.log;
    if (const std::string bad = bad_end(ended); !bad.empty()) throw std::runtime_error(bad);
    const ImageSpec& size = scene.view.image;
    for (const Shot& shot : shots) {
      drawn[shot.name] = believed([&] {
        return read_gpu_image(folder.path() / (shot.name + ".bin"), size.width, size.height);
      });
    }
  }

  Interface interface_;
  Programs programs_;
};

}  // namespace

std::unique_ptr<Renderer> gl_renderer(const Programs& programs) {
  return std::make_unique<Gpu>(kGl, programs);
}
std::unique_ptr<Renderer> gles_renderer(const Programs& programs) {
  return std::make_unique<Gpu>(kGles, programs);
}
std::unique_ptr<Renderer> vulkan_renderer(const Programs& programs) {
  return std::make_unique<Gpu>(kVulkan, programs);
}
std::unique_ptr<Renderer> hlsl_renderer(const Programs& programs) {
  return std::make_unique<Gpu>(kHlsl, programs);
}

}  // namespace lumaknot
