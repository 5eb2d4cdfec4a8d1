/// Pixels of the exact tube's image: point samples, and means over the pixels' squares.
#pragma once

#include <vector>

#include "render/exact/tube.h"
#include "render/shading.h"

namespace lumaknot::exact {

/// A colour and its coverage.
struct Sample {
  Vec3d color;
  double coverage = 0;

  friend Sample operator+(const Sample& a, const Sample& b) {
    return {a.color + b.color, a.coverage + b.coverage};
  }
  friend Sample operator-(const Sample& a, const Sample& b) {
    return {a.color - b.color, a.coverage - b.coverage};
  }
  friend Sample operator*(const Sample& a, double s) { return {a.color * s, a.coverage * s}; }
};

/// The exact tube through a scene's camera, lit by its lights; keeps the scene by reference.
class ExactPixels {
 public:
  ExactPixels(const Scene& scene, const KnotSpec& knot);

  /// The fragment seen at the image point (x, y), in pixels from the top left.
  ExactFragment at(double x, double y) const { return at(x, y, near_); }

  /// The fragment it would see if nothing were nearer than the depth `beyond`.
  ExactFragment at(double x, double y, double beyond) const;

  /// The width of a pixel at depth one.
  double pixel_width() const { return projection_.pixel_width(); }

  Sample sample(const Fragment& seen) const {
    return {shading_.color(seen), seen.covered() ? 1.0 : 0.0};
  }

 private:
  ExactTube tube_;
  Projection projection_;
  Vec3d eye_;
  double near_;
  Shot shot_;
  Shading shading_;
};

/// A pixel and its estimated error: that of the worst channel, coverage included.
struct PixelTruth {
  Sample sample;
  double error = 0;
};

/// The means over the pixels (0, y) to (width - 1, y), their estimated errors at most `tolerance`.
///
/// The square with the largest estimated error is quartered until the sum is within the tolerance.
/// Rays are cast at a grid of half pixels and at one point off it. Where these show one smooth
/// piece of the surface, samples come from the biquadratic surface through the grid's nine points;
/// elsewhere each sample casts its own ray.
std::vector<PixelTruth> area_row(const ExactPixels& pixels, int y, int width, double tolerance);

}  // namespace lumaknot::exact
