#include "study/frame_time.h"

#include <algorithm>
#include <chrono>

namespace lumaknot {
namespace {

constexpr int kFrames = 3;  // of each round

double milliseconds_of(const DrawFrame& frame) {
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  frame();
  return std::chrono::duration<double, std::milli>(Clock::now() - before).count();
}

}  // namespace

FrameRound time_round(const DrawFrame& frame, const DrawFrame& beside) {
  const bool slow = milliseconds_of(frame) > kSlowFrame;
  double beside_time = milliseconds_of(beside), time = milliseconds_of(frame);
  for (int i = 1; i < (slow ? 1 : kFrames); ++i) {
    beside_time = std::min(beside_time, milliseconds_of(beside));
    time = std::min(time, milliseconds_of(frame));
  }
  return {time / beside_time, time};
}

}  // namespace lumaknot
