/// The built-in texture.
#pragma once

#include "scene/image.h"

namespace lumaknot {

/// A procedural brick wall, 512 x 512, that tiles seamlessly. Values are multiples of 1/255, so
/// that an 8-bit file holds them exactly.
TextureImage bricks();

}  // namespace lumaknot
