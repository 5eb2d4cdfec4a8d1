/// FLIP, the difference that a viewer sees when two images alternate: P. Andersson et al., "FLIP:
/// A Difference Evaluator for Alternating Images", HPG 2020, for images of low dynamic range.
#pragma once

#include "scene/image.h"
#include "shaders/spaces/cielab.h"

namespace lumaknot::validate {

/// Pixels per degree of the viewer's eye: 3840 pixels on 0.7 m, seen from 0.7 m, as in the paper.
inline constexpr double kFlipPixelsPerDegree = 67.0206432765823;

/// What FLIP compares of an image, computed once per image.
struct FlipImage {
  Grid<Lab<float>> colors;    ///< as the eye resolves them, Hunt-adjusted
  Grid<float> edges, points;  ///< how strong features are
  double pixels_per_degree = 0;
};

/// The colours of `image` are limited to [0, 1].
FlipImage flip_image(const Image& image, double pixels_per_degree = kFlipPixelsPerDegree);

/// The error of each pixel, in [0, 1]. Both have the same size and pixels per degree.
Grid<float> flip_errors(const FlipImage& reference, const FlipImage& test);

/// The same from images of one size, computed only near pixels of which a channel, limited to
/// [0, 1], differs by `from` or more, and 0 elsewhere.
Grid<float> flip_errors_near(const Image& reference, const Image& test, float from);

/// The mean of all pixels, including the background's: FLIP's usual single number.
double mean_flip(const FlipImage& reference, const FlipImage& test);

}  // namespace lumaknot::validate
