/// Pictures through a pixel filter: the expectation of a renderer that samples pixels at random.
#pragma once

#include <array>

#include "render/reference.h"

namespace lumaknot {

/// Red, green, blue, premultiplied, and coverage.
using Channels = std::array<double, 4>;

/// How samples lie about a pixel's centre, along x, and likewise upwards along y.
struct PixelFilter {
  double (*density)(double offset);  ///< per pixel, at `offset` pixels; its integral is 1
  double reach;                      ///< beyond this offset it is 0; at most 1.75
};

/// A shot through a filter, estimated twice.
struct FilteredImage {
  std::array<Grid<Channels>, 2> halves;  ///< from different samples, equally many
  Grid<Channels> spread;                 ///< the standard deviation of one random sample
  Grid<Channels> reach;                  ///< the largest distance of a sample from the mean
};

/// Of `samples` per pixel at least, all told; a multiple of 128 is taken. On all cores; the same
/// bytes whatever their number. Throws Interrupted when the user asked to stop.
FilteredImage render_filtered(const Scene& scene, const Shot& shot, const PixelFilter& filter,
                              int samples);

}  // namespace lumaknot
