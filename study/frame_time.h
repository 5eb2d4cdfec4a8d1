/// How long frames take, measured beside other frames.
#pragma once

#include <functional>

namespace lumaknot {

/// Draws one frame.
using DrawFrame = std::function<void()>;

/// Frames that take longer are drawn fewer times. Milliseconds.
inline constexpr double kSlowFrame = 100;

/// Timed frames are drawn on so many threads: of several, some may share a core.
inline constexpr int kTimedThreads = 1;

/// What a round measured.
struct FrameRound {
  double ratio = 0, milliseconds = 0;  ///< of the frames beside; itself
};

/// One frame unseen, since it takes the memory; then the least of a few frames in turns with
/// `beside`'s: what else the machine does only makes frames longer.
FrameRound time_round(const DrawFrame& frame, const DrawFrame& beside);

}  // namespace lumaknot
