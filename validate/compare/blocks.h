/// Grids made smaller.
#pragma once

#include <algorithm>

#include "scene/image.h"

namespace lumaknot::validate {

/// A grid with a pixel for each block x block pixels of `grid`; those at the right and bottom may
/// be fewer. of_block(each) makes it, where each(visit) calls visit(pixel) for the block's pixels.
template <class Result, class Pixel, class OfBlock>
Grid<Result> per_block(const Grid<Pixel>& grid, int block, const OfBlock& of_block) {
  Grid<Result> result((grid.width + block - 1) / block, (grid.height + block - 1) / block);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      result.at(x, y) = of_block([&](auto visit) {
        for (int j = y * block; j < std::min(grid.height, (y + 1) * block); ++j) {
          for (int i = x * block; i < std::min(grid.width, (x + 1) * block); ++i) {
            visit(grid.at(i, j));
          }
        }
      });
    }
  }
  return result;
}

/// The means of blocks of colours; color(pixel) gives a pixel's.
template <class Pixel, class ColorOf>
Grid<Rgb> block_means(const Grid<Pixel>& grid, int block, const ColorOf& color) {
  return per_block<Rgb>(grid, block, [&](const auto& each) {
    Rgb sum;
    float count = 0;
    each([&](const Pixel& pixel) {
      const Rgb c = color(pixel);
      sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
      ++count;
    });
    return Rgb{sum.r / count, sum.g / count, sum.b / count};
  });
}

/// The largest of each block.
template <class Value>
Grid<Value> block_maxima(const Grid<Value>& grid, int block) {
  return per_block<Value>(grid, block, [](const auto& each) {
    Value max{};
    each([&](const Value& value) { max = std::max(max, value); });
    return max;
  });
}

}  // namespace lumaknot::validate
