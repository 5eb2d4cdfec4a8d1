/// A scene as fast frames read it.
#pragma once

#include "render/frame_data.h"

namespace lumaknot {

/// What a packet may reach behind the last of an array.
inline constexpr std::size_t kPadding = 16;

/// All that doesn't change from frame to frame, in single precision where that suffices.
FrameData frame_data(const Scene& scene, const FastOptions& options);

}  // namespace lumaknot
