/// Sketches as pictures, and what two of them differ by.
#pragma once

#include <optional>
#include <string>

#include "scene/image.h"

namespace lumaknot::stability {

/// `image` as a displayable PNG: pixels that are not numbers in magenta.
std::string sketch_png(const Image& image);

/// The differences of two sketches' channels, times `gain`.
struct SketchDifference {
  Image image;
  int gain = 1;  ///< a power of two, to 256: nine tenths of the pixels that differ are not clipped
};

/// How two sketches of equal size differ as they are displayed, unrounded, if they look alike: if
/// the root mean square of the pixels' largest channels differs by less than a tenth of full scale.
/// Empty if they don't.
std::optional<SketchDifference> difference_if_alike(const Image& a, const Image& b);

}  // namespace lumaknot::stability
