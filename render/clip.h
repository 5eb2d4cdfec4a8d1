/// Triangles that reach behind the near plane or far beyond the image.
#pragma once

#include "render/frame_data.h"

namespace lumaknot {

/// Finds the run's triangles with a corner outside, but those behind the near plane: `run.cut`.
void find_cut(const FrameData& data, Run& run);

/// Cuts `triangles` at the near plane and the guard, and appends their pieces to `data`, behind the
/// mesh's own. Their vertices have what is interpolated between the corners.
void clip_triangles(FrameData& data, std::span<const std::uint32_t> triangles);

}  // namespace lumaknot
