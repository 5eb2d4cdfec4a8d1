/// Pictures whose measures are known.
#pragma once

#include <gmock/gmock.h>

#include "study/paper/claim.h"
#include "study/paper/picture_measures.h"

namespace lumaknot::paper {

inline Image filled(Rgb color) {
  Image image(4, 4);
  for (RgbaPixel& p : image.pixels) p = {color, 1};
  return image;
}

/// `image` with its first pixel changed.
inline Image with_first(Image image, Rgb color) {
  image.pixels[0].color = color;
  return image;
}

inline Marks everywhere() { return Marks(16, 1); }

/// The measure called `what`.
inline const Measure& measure(const PaperClaim& claim, const std::string& what) {
  const auto found = std::ranges::find(claim.measures, what, &Measure::what);
  if (found == claim.measures.end()) throw std::runtime_error("no measure " + what);
  return *found;
}

}  // namespace lumaknot::paper
