/// The positions of a pixel's samples.
#pragma once

#include <cstdint>
#include <span>

namespace lumaknot::fast {

/// A sample's offset from the pixel's centre, in sixteenths of a pixel, y downwards.
struct SamplePlace {
  std::int8_t x, y;
};

/// Direct3D 11's standard patterns for 1, 2, 4, 8 and 16 samples, and for 6, which has none, one
/// whose samples share no row or column. Empty for other numbers.
std::span<const SamplePlace> sample_pattern(int samples);

}  // namespace lumaknot::fast
