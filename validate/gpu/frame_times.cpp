#include "validate/gpu/frame_times.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "validate/gpu/fields.h"
#include "validate/gpu/gl_run.h"

namespace lumaknot::gpu {
namespace {

constexpr int kWarmUp = 2;  // uncounted frames of each draw

/// Milliseconds, to a tenth of a microsecond.
double time_of_frame(const GlRun& run, unsigned program) {
  const auto start = std::chrono::steady_clock::now();
  run.draw_frame(program);
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  return std::round(ms.count() * 1e4) / 1e4;
}

}  // namespace

void draw_frames(const Job& job) {
  const GlRun run(job);
  std::vector<unsigned> programs;
  for (const Draw& draw : job.draws) programs.push_back(run.prepare(draw));
  std::vector<std::vector<double>> times(job.draws.size());
  for (int round = -kWarmUp; round < job.frames; ++round) {
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const double ms = time_of_frame(run, programs[i]);
      if (round >= 0) times[i].push_back(ms);
    }
  }
  for (std::size_t i = 0; i < programs.size(); ++i) {  // reading back would disturb the others
    run.draw_frame(programs[i]);
    run.write_image(job.draws[i]);
  }
  Json json{{"renderer", gl_renderer()}, {"samples", run.samples()}};
  for (std::size_t i = 0; i < programs.size(); ++i) {
    json["draws"].push_back({{"name", job.draws[i].name}, {"ms", times[i]}});
  }
  fmt::print("{}\n", json.dump());
}

}  // namespace lumaknot::gpu
