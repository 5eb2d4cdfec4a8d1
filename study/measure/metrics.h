/// How far a drawn image is from the true one, by the usual measures.
#pragma once

#include "scene/image.h"
#include "validate/compare/flip.h"

namespace lumaknot::measure {

/// Errors of what a display shows: colours limited to [0, 1]. All but FLIP are of the pixels that
/// either image covers, so that the background doesn't dilute them; FLIP is of all.
struct Errors {
  double rmse = 0;                                        ///< of all channels
  double max = 0, p999 = 0;                               ///< of a pixel's largest channel
  double delta_e = 0, delta_e_max = 0, delta_e_p999 = 0;  ///< CIEDE2000: mean, largest, 99.9 %
  double flip = 0;                                        ///< the mean; kFlipPixelsPerDegree
};

/// An image prepared for comparison.
struct SeenImage {
  Image image;  ///< limited to [0, 1]
  Grid<Lab<double>> colors;
  validate::FlipImage flip;
};

SeenImage seen(Image image);

/// Both have the same size. Zero if neither covers a pixel.
Errors errors_between(const SeenImage& truth, const SeenImage& image);

}  // namespace lumaknot::measure
