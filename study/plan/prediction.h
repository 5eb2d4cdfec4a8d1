/// Errors that are known before anything is drawn.
#pragma once

#include <optional>
#include <span>

#include "meshgen/spine.h"
#include "study/measure/method.h"
#include "study/plan/bounds.h"
#include "study/plan/simplification.h"
#include "study/plan/tolerance.h"

namespace lumaknot::plan {

/// Upper bounds of a method's errors by part. Colours are of the largest channel; empty
/// without a simple bound.
struct PredictedError {
  double place = 0;               ///< pixels: how far from its place the mesh shows the surface
  double sampling = 0;            ///< pixels: an edge between two samples
  std::optional<double> shading;  ///< the normal between vertices, or light between vertices
  std::optional<double> filter;   ///< the texture's
  double precision = 0;           ///< rounding

  /// Whether the bounds alone guarantee the tolerance if `dropped` of it is used up.
  bool promises(const Tolerance& tolerance, double dropped) const;
};

/// The bounds of one scene's methods.
///
/// Place: Filip, Magedson and Markot's bound of what is between vertices (meshgen/deviation.h),
/// over the width of a pixel at the nearest visible point. Shading: the normal's bound times
/// the terms' sensitivity to its turning: Lambert's by 1, Minnaert's by 2 k - 1, a highlight
/// cos^k by sqrt(k / e), Phong's by twice that since its reflection turns twice as fast; lighting
/// per vertex by the terms' second derivatives, and where they bend sharply by a quarter of their
/// slope. Filter: the texture's contrast times the light. Precision: 2^-24 times the roundings on
/// the way.
class Predictor {
 public:
  /// `seen`: the covered points of the exact surface that the picture shows. Keeps nothing by
  /// reference.
  Predictor(const SimplifiedScene& simplified, const KnotSpec& knot, std::span<const Fragment> seen,
            const Tolerance& tolerance);

  PredictedError of(const measure::Method& method) const;

  const Tolerance& tolerance() const { return tolerance_; }

  /// Scene units: a pixel's width at the nearest visible point.
  double pixel() const { return pixel_; }

 private:
  std::optional<double> per_pixel(double normal_turn, double offset) const;
  std::optional<double> per_vertex(const measure::Method& method) const;
  std::optional<double> filter(const measure::Method& method) const;

  KnotSpec knot_;
  Spine spine_;
  Tolerance tolerance_;
  Material material_;
  double pixel_ = 0, nearest_ = 0;
  double speed_ = 0, curvature_ = 0;  ///< the centre line's largest
  std::optional<LightBounds> lights_;
  double ambient_ = 0, emissive_ = 0;
  TextureBounds texture_;
  Vec2d texels_{0, 0};  ///< along and around the tube
};

}  // namespace lumaknot::plan
