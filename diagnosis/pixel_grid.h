/// The pixels that are compared.
#pragma once

#include <cstddef>

namespace lumaknot::diagnosis {

/// Every `step`-th pixel of a picture in both directions; the step is odd, so that the centre of a
/// step x step block is a pixel's centre.
struct PixelGrid {
  int width = 0, height = 0;  ///< of the picture
  int step = 1;
  int columns = 0, rows = 0;

  std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
  int x(std::size_t i) const { return int(i % std::size_t(columns)) * step + step / 2; }
  int y(std::size_t i) const { return int(i / std::size_t(columns)) * step + step / 2; }
};

/// The finest grid of at most `max_pixels` pixels, or one of a single pixel.
constexpr PixelGrid pixel_grid(int width, int height, long long max_pixels) {
  PixelGrid grid{width, height, 1, width, height};
  while (1LL * grid.columns * grid.rows > max_pixels && grid.columns > 1 && grid.rows > 1) {
    grid.step += 2;
    grid.columns = width / grid.step;
    grid.rows = height / grid.step;
  }
  return grid;
}

}  // namespace lumaknot::diagnosis
