// lumaknot-gpu JOB.json                         draws what the job file says; prints timed frames
//                                               as JSON
// lumaknot-gpu --version-of gl|gles|vulkan      prints the renderer and its driver
// lumaknot-gpu --version-of gl-hardware         prints those of a GPU
// Exit code 0: done; 2: wrong usage or a bad job; 3: no such API, or a shader that does not
// compile.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "system/atomic_file.h"
#include "system/error.h"
#include "validate/gpu/frame_times.h"
#include "validate/gpu/gl_run.h"
#include "validate/gpu/job.h"
#include "validate/gpu/vulkan_run.h"

namespace lumaknot::gpu {
namespace {

constexpr int kExitBadJob = 2, kExitUnavailable = 3;

/// Mesa's software drivers, without a shader cache. The caller's environment takes precedence.
void prefer_software() {
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

void allow_hardware() { ::unsetenv("LIBGL_ALWAYS_SOFTWARE"); }

void draw_on_vulkan(const Job& job) {
  VulkanRun run(job);
  for (const Draw& draw : job.draws) {
    const std::vector<float> pixels = run.draw(draw);
    write_file(draw.output,
               {reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(float)},
               draw.where + ".output");
  }
}

void draw_on_gl(const Job& job) {
  const GlRun run(job);
  for (const Draw& draw : job.draws) {
    run.draw_frame(run.prepare(draw));
    run.write_image(draw);
  }
}

void run_job(const std::string& file) {
  const Job job = read_job(file);
  if (job.hardware) allow_hardware();
  if (job.api == Api::kVulkan) return draw_on_vulkan(job);
  if (job.frames == 0) return draw_on_gl(job);
  draw_frames(job);
}

std::string version_of(Api api) {
  if (api == Api::kVulkan) return vulkan_version();
  const GlContext context(api, false);
  return gl_version();
}

std::string version_of_hardware() {
  allow_hardware();
  const GlContext context(Api::kGl, true);
  return gl_version();
}

void run(const std::vector<std::string>& arguments) {
  if (arguments == std::vector<std::string>{"--version-of", "gl-hardware"}) {
    fmt::print("{}\n", version_of_hardware());
  } else if (arguments.size() == 2 && arguments[0] == "--version-of") {
    fmt::print("{}\n", version_of(api_named(arguments[1], "--version-of")));
  } else if (arguments.size() == 1 && !arguments[0].starts_with("-")) {
    run_job(arguments[0]);
  } else {
    throw Error("usage: lumaknot-gpu JOB.json, or --version-of gl|gles|vulkan");
  }
}

/// Prints bad input on one line, whatever it quotes.
void print_error(std::string message) {
  std::ranges::replace_if(message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  fmt::print(stderr, "lumaknot-gpu: {}\n", message);
}

int run_program(const std::vector<std::string>& arguments) {
  prefer_software();
  try {
    run(arguments);
    return 0;
  } catch (const Error& e) {
    print_error(e.what());
    return kExitBadJob;
  } catch (const std::bad_alloc&) {
    print_error("out of memory; lower width and height");
  } catch (const std::exception& e) {  // Unavailable, vk::Error
    fmt::print(stderr, "lumaknot-gpu: {}\n", e.what());
  }
  return kExitUnavailable;
}

}  // namespace
}  // namespace lumaknot::gpu

int main(int argc, char** argv) { return lumaknot::gpu::run_program({argv + 1, argv + argc}); }
