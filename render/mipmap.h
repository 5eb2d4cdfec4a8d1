/// A texture as the fast renderer reads it.
#pragma once

#include <array>
#include <cstdint>

#include "render/filter.h"
#include "scene/bulk.h"
#include "scene/scene.h"

namespace lumaknot {

/// As many halves as the largest texture has, and then a packet's lanes.
constexpr std::size_t kMostLevels = 16;

/// The sizes of a texture, each texel row by row from the bottom, with a border of one texel of
/// what wrapping finds there, so that neighbours always follow each other.
struct MipLevels {
  template <class T>
  using OfEach = std::array<T, kMostLevels>;

  std::size_t count = 0;
  alignas(64) OfEach<std::int32_t> widths{}, heights{};  ///< without the border
  OfEach<std::int32_t> strides{};                        ///< texels from a row to the next
  OfEach<std::int32_t> firsts{};                         ///< texel (0, 0) of all texels
};

/// A texture and its halves, down to one texel. Texels are packed bytes where that loses nothing of
/// the image, else floats of which each texel has four; a plain colour has none.
struct Mipmap {
  MipLevels levels;
  Bulk<std::uint32_t> bytes;  ///< r, g, b from the lowest byte on
  Bulk<float> floats;
  Vec3d color;  ///< where there are no levels
};

/// The levels of `texture`; the first alone unless `all`. With `material` baked, texels are the
/// axes of its space.
Mipmap make_mipmap(const Texture& texture, const Material& material, Wrapping wrapping, bool all);

}  // namespace lumaknot
