/// How long frames take, measured next to other frames.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace lumaknot::measure {

/// Draws one frame.
using DrawFrame = std::function<void()>;

/// Frames that take longer are drawn fewer times. Milliseconds.
inline constexpr double kSlowFrame = 100;

/// Slow frames are timed in this many rounds: no other times are close to theirs.
inline constexpr std::size_t kSlowRounds = 3;

/// The number of threads that draw timed frames: of several, some may share a core.
inline constexpr int kTimedThreads = 1;

/// The result of a round.
struct FrameRound {
  double ratio = 0, milliseconds = 0;  ///< to the baseline's frames; of the frame itself
};

/// One frame untimed, since it allocates the memory; then the fastest of a few frames alternating
/// with `baseline`'s: other load on the machine only makes frames longer.
FrameRound time_round(const DrawFrame& frame, const DrawFrame& baseline);

/// Whether frames that took `milliseconds`, one number per round so far, are still to be timed in
/// `round`, counted from 0.
bool needs_round(std::span<const double> milliseconds, std::size_t round);

}  // namespace lumaknot::measure
