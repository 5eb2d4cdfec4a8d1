/// Triangles that reach behind the near plane or far beyond the image.
#pragma once

#include "render/frame_data.h"

namespace lumaknot {

/// Cuts each triangle with a corner outside at the near plane and the guard, and appends its pieces
/// to `data`, behind the mesh's own. Their vertices have what is interpolated between its corners.
void clip_triangles(FrameData& data);

}  // namespace lumaknot
