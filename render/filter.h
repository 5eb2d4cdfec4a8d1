/// How the fast renderer reads textures.
#pragma once

namespace lumaknot {

/// How a texture image is looked up between its texels.
enum class Filter {
  kBilinear,   ///< as the reference: the four nearest texels
  kTrilinear,  ///< of the two mipmap levels nearest to the pixel's footprint
};

/// What becomes of texture coordinates outside [0, 1].
enum class Wrapping { kRepeat, kClamp };

}  // namespace lumaknot
