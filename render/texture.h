/// Texture look-up.
#pragma once

#include "scene/spec.h"

namespace lumaknot {

/// The texture at `uv`: bilinear between texel centres at (i + 0.5) / size, repeating in both
/// directions, v upwards from the bottom row; or the plain colour. `uv` must be finite.
Vec3d texture_color(const Texture& texture, const Vec2d& uv);

}  // namespace lumaknot
