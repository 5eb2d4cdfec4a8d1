/// Images in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace lumaknot {

/// width x height pixels of `Pixel`, row by row from the top left; pixel centres are at +0.5.
template <class Pixel>
struct Grid {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;  ///< width * height

  Grid() = default;
  Grid(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}

  Pixel& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Pixel& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// Encoded r'g'b' values, used as they are: no transfer function anywhere.
struct Rgb {
  float r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

inline Vec3d to_vec(const Rgb& c) { return {c.r, c.g, c.b}; }
inline Rgb to_rgb(const Vec3d& c) { return {float(c.x), float(c.y), float(c.z)}; }

/// A texture, its values in [0, 1].
using TextureImage = Grid<Rgb>;

/// A rendered pixel: the colour, premultiplied by the coverage, and the covered share in [0, 1].
struct RgbaPixel {
  Rgb color;
  float coverage = 0;
};

/// A rendered image over a black, transparent background. Colours may leave [0, 1].
using Image = Grid<RgbaPixel>;

}  // namespace lumaknot
