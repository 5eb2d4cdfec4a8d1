/// A texture in the form the fast renderer reads.
#pragma once

#include <array>
#include <cstdint>

#include "render/filter.h"
#include "scene/spec.h"
#include "system/bulk.h"

namespace lumaknot::fast {

/// As many levels as the largest texture has, plus a packet's lanes.
constexpr std::size_t kMaxLevels = 16;

/// The levels of a texture, each stored row by row from the bottom, with a border of one texel
/// filled by wrapping, so that neighbours are always adjacent.
struct MipLevels {
  template <class T>
  using OfEach = std::array<T, kMaxLevels>;

  std::size_t count = 0;
  alignas(64) OfEach<std::int32_t> widths{}, heights{};  ///< without the border
  OfEach<std::int32_t> strides{};                        ///< texels from one row to the next
  OfEach<std::int32_t> firsts{};                         ///< index of texel (0, 0) among all texels
};

/// A texture and its mipmap levels, down to one texel. Texels are packed bytes where that loses
/// nothing of the image, else four floats each; a plain colour has none.
struct Mipmap {
  MipLevels levels;
  Bulk<std::uint32_t> bytes;  ///< r, g, b from the lowest byte on
  Bulk<float> floats;
  Vec3d color;  ///< if there are no levels
};

/// The levels of `texture`; only the first unless `all`. With `material` baked, texels are on the
/// axes of its space.
Mipmap make_mipmap(const Texture& texture, const Material& material, Wrapping wrapping, bool all);

}  // namespace lumaknot::fast
