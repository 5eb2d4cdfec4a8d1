/// A scene in the form fast frames read.
#pragma once

#include "render/fast/frame_data.h"

namespace lumaknot::fast {

/// How far a packet may reach past the end of an array.
inline constexpr std::size_t kPadding = 16;

/// Everything that doesn't change from frame to frame, in single precision where that suffices.
FrameData frame_data(const Scene& scene, const Options& options);

}  // namespace lumaknot::fast
