/// How the fast renderer reads textures.
#pragma once

namespace lumaknot {

/// How a texture is filtered between its texels.
enum class Filter {
  kBilinear,   ///< as the reference: the four nearest texels
  kTrilinear,  ///< from the two mipmap levels nearest to the pixel's footprint
};

/// How texture coordinates outside [0, 1] are treated.
enum class Wrapping { kRepeat, kClamp };

}  // namespace lumaknot
