/// A texture as the fast renderer reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "render/filter.h"
#include "scene/bulk.h"
#include "scene/scene.h"

namespace lumaknot {

/// One size of a texture: its texels row by row from the bottom, with a border of one texel of what
/// wrapping finds there, so that neighbours always follow each other.
struct MipLevel {
  int width = 0, height = 0;  ///< without the border
  int stride = 0;             ///< texels from a row to the next
  int first = 0;              ///< texel (0, 0) of all texels
};

/// A texture and its halves, down to one texel. Texels are packed bytes where that loses nothing of
/// the image, else floats of which each texel has four; a plain colour has none.
struct Mipmap {
  std::vector<MipLevel> levels;
  Bulk<std::uint32_t> bytes;  ///< r, g, b from the lowest byte on
  Bulk<float> floats;
  Vec3d color;  ///< where there are no levels
};

/// The levels of `texture`; the first alone unless `all`. With `material` baked, texels are the
/// axes of its space.
Mipmap make_mipmap(const Texture& texture, const Material& material, Wrapping wrapping, bool all);

}  // namespace lumaknot
