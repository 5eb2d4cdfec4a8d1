#include "study/measure/frame_time.h"

#include <algorithm>
#include <chrono>

#include "study/measure/statistics.h"

namespace lumaknot::measure {
namespace {

constexpr int kFrames = 3;  // of each round

double milliseconds_of(const DrawFrame& frame) {
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  frame();
  return std::chrono::duration<double, std::milli>(Clock::now() - before).count();
}

}  // namespace

FrameRound time_round(const DrawFrame& frame, const DrawFrame& baseline) {
  const bool slow = milliseconds_of(frame) > kSlowFrame;
  double baseline_time = milliseconds_of(baseline), time = milliseconds_of(frame);
  for (int i = 1; i < (slow ? 1 : kFrames); ++i) {
    baseline_time = std::min(baseline_time, milliseconds_of(baseline));
    time = std::min(time, milliseconds_of(frame));
  }
  return {time / baseline_time, time};
}

bool needs_round(std::span<const double> milliseconds, std::size_t round) {
  const std::size_t had = milliseconds.size();
  if (had > round) return false;
  return had < kSlowRounds || median({milliseconds.begin(), milliseconds.end()}) < kSlowFrame;
}

}  // namespace lumaknot::measure
