/// Differences of pictures, pixel by pixel.
#pragma once

#include "math/vec.h"
#include "render/fast/renderer.h"
#include "scene/image.h"

namespace lumaknot::measure {

/// Differences of a picture's channels from another's, signed.
using ErrorMap = Grid<Vec3d>;

/// A picture's colours; bytes are 255ths.
ErrorMap colors_of(const Image& image);
ErrorMap colors_of(const Grid<fast::Rgba8>& image);

/// Each channel limited to [0, 1].
ErrorMap limited(ErrorMap map);

ErrorMap minus(ErrorMap a, const ErrorMap& b);

}  // namespace lumaknot::measure
