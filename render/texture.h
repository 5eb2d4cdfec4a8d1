/// Texture look-up.
#pragma once

#include <cmath>

#include "scene/spec.h"

namespace lumaknot {

/// Two neighbouring texels on one axis and the weight of the second.
struct TexelPair {
  int first, second;
  double weight;
};

/// Those around a texture coordinate, which repeats; `size` texels make one tile.
inline TexelPair texel_pair(double coordinate, int size) {
  const double wrapped = coordinate - std::floor(coordinate);
  const double texel = wrapped * size - 0.5;
  const double first = std::floor(texel);
  const int index = int(first);
  return {(index + size) % size, (index + 1) % size, texel - first};
}

/// The texture at `uv`, bilinear between the values of `of_texel`, a function of a texel's colour.
template <class F>
Vec3d bilinear(const TextureImage& image, const Vec2d& uv, F of_texel) {
  const TexelPair x = texel_pair(uv.u, image.width), y = texel_pair(1 - uv.v, image.height);
  const auto row = [&](int j) {
    const Vec3d left = of_texel(to_vec(image.at(x.first, j)));
    const Vec3d right = of_texel(to_vec(image.at(x.second, j)));
    return left + (right - left) * x.weight;
  };
  const Vec3d above = row(y.first), below = row(y.second);
  return above + (below - above) * y.weight;
}

/// The texture at `uv`: bilinear between texel centres at (i + 0.5) / size, repeating in both
/// directions, v upwards from the bottom row; or the plain colour. `uv` must be finite.
Vec3d texture_color(const Texture& texture, const Vec2d& uv);

/// The next level of a mipmap: half as wide and high, at least one texel. Each texel is the mean of
/// those it covers, also if a side is odd.
TextureImage halved(const TextureImage& image);

}  // namespace lumaknot
