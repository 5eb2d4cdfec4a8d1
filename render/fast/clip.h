/// Triangles that reach behind the near plane or far beyond the image.
#pragma once

#include "render/fast/frame_data.h"

namespace lumaknot::fast {

/// Fills `run.cut`: the run's triangles with a corner outside, except those behind the near plane.
void find_cut(const FrameData& data, Run& run);

/// Cuts `triangles` at the near plane and the guard, and appends their pieces to `data` after the
/// mesh's own triangles. Their vertices interpolate those of the corners.
void clip_triangles(FrameData& data, std::span<const std::uint32_t> triangles);

}  // namespace lumaknot::fast
