// lumaknot-embree JOB.json     draws what the job file says; prints each frame's time as JSON
// lumaknot-embree --version    prints Embree's version Exit code 0: done; 2: wrong usage or a bad
// job; 3: Embree failed.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/embree/frame.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::embree {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kExitBadJob = 2, kExitUnavailable = 3;

/// Milliseconds that `work` takes, to a tenth of a microsecond.
template <class Work>
double timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  return std::round(ms.count() * 1e4) / 1e4;
}

void write_frame(const Frame& frame, const std::filesystem::path& path) {
  std::vector<float> values;
  values.reserve(frame.pixels.size() * 4);
  for (const std::uint32_t pixel : frame.pixels) {
    for (int c = 0; c < 4; ++c) values.push_back(float(pixel >> 8 * c & 255) / 255);
  }
  write_file(path, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)},
             "output");
}

/// The frames' times of each draw, in turns; the last frames are written.
Json draws_json(const Job& job) {
  const Surface surface(job);
  const Tracer tracer(job.mesh);
  std::vector<Frame> frames;
  frames.reserve(job.draws.size());
  for (const Draw& draw : job.draws) {
    frames.emplace_back(draw.view.image.width, draw.view.image.height);
  }
  std::vector<std::vector<double>> times(job.draws.size());
  for (int round = 0; round <= job.frames; ++round) {  // the first is not counted
    for (std::size_t i = 0; i < job.draws.size(); ++i) {
      const double ms =
          timed([&] { draw_frame(tracer, surface, job.draws[i], job.samples, frames[i]); });
      if (round > 0) times[i].push_back(ms);
    }
  }
  Json json;
  for (std::size_t i = 0; i < job.draws.size(); ++i) {
    write_frame(frames[i], job.draws[i].output);
    json.push_back({{"name", job.draws[i].name}, {"ms", times[i]}});
  }
  return json;
}

std::string version() {
  return fmt::format("{}, {}", Tracer(gpu::Mesh{}).version(), shading_width());
}

void run_job(const std::string& file) {
  using Control = oneapi::tbb::global_control;
  const Job job = read_job(file);
  const auto cores = Control::active_value(Control::max_allowed_parallelism);
  const Control limit(Control::max_allowed_parallelism,
                      job.threads > 0 ? std::size_t(job.threads) : cores);
  const Json json{{"renderer", version()}, {"samples", job.samples}, {"draws", draws_json(job)}};
  fmt::print("{}\n", json.dump());
}

void run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 1 && arguments[0] == "--version") {
    fmt::print("{}\n", version());
  } else if (arguments.size() == 1 && !arguments[0].starts_with("-")) {
    run_job(arguments[0]);
  } else {
    throw Error("usage: lumaknot-embree JOB.json, or --version");
  }
}

/// Prints an error on one line, whatever it quotes.
int fail_with(std::string message, int exit_code) {
  std::ranges::replace_if(message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  fmt::print(stderr, "lumaknot-embree: {}\n", message);
  return exit_code;
}

int run_program(const std::vector<std::string>& arguments) {
  try {
    run(arguments);
    return 0;
  } catch (const Error& e) {
    return fail_with(e.what(), kExitBadJob);
  } catch (const std::bad_alloc&) {
    return fail_with("out of memory; lower width and height", kExitUnavailable);
  } catch (const std::exception& e) {
    return fail_with(e.what(), kExitUnavailable);
  }
}

}  // namespace
}  // namespace lumaknot::embree

int main(int argc, char** argv) { return lumaknot::embree::run_program({argv + 1, argv + argc}); }
