#include "study/plan/prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/angle.h"
#include "meshgen/deviation.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/sharpest_bend.h"
#include "render/fast/renderer.h"
#include "render/projection.h"

namespace lumaknot::plan {
namespace {

constexpr double kRounding = 0x1p-24;  // of float, relative

/// The largest change of a term per radian that the normal turns.
std::optional<double> diffuse_slope(const Material& m) {
  return with_diffuse(m.model, m.parameters, [](auto term, auto... p) { return term.slope(p...); });
}
std::optional<double> specular_slope(const Material& m) {
  return with_highlight(m.model, m.parameters,
                        [](auto term, auto... p) { return term.slope(p...); });
}

double max_speed(const Spine& spine) {
  double max = 0;
  for (int i = 0; i < 1024; ++i) {
    max = std::max(
        max,
        length(curve_point(spine.curve(), torus_angles(spine.curve(), kTurn * i / 1024)).first));
  }
  return max;
}

double nearest_depth(std::span<const Fragment> seen) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Fragment& f : seen) nearest = std::min(nearest, f.depth);
  return nearest;
}

/// A part of a sum, possibly without a bound; one of weight 0 needs none.
std::optional<double> part_of(double weight, std::optional<double> bound) {
  if (weight > 0) return bound ? std::optional(weight * *bound) : std::nullopt;
  return 0;
}

/// The sum of two such parts.
std::optional<double> sum_of(double a, std::optional<double> of_a, double b,
                             std::optional<double> of_b) {
  const std::optional<double> first = part_of(a, of_a), second = part_of(b, of_b);
  if (!first || !second) return {};
  return *first + *second;
}

}  // namespace

bool PredictedError::promises(const Tolerance& tolerance, double dropped) const {
  if (!shading || !filter) return false;
  return place + sampling <= tolerance.shift &&
         *shading + *filter + precision + dropped <= tolerance.color;
}

Predictor::Predictor(const SimplifiedScene& simplified, const KnotSpec& knot,
                     std::span<const Fragment> seen, const Tolerance& tolerance)
    : knot_(knot),
      spine_(centre_lines(knot).front()),
      tolerance_(tolerance),
      material_(simplified.view.material),
      speed_(max_speed(spine_)),
      curvature_(sharpest_bend(spine_.curve()).curvature),
      lights_(light_bounds(simplified.view, texture_bounds(simplified.texture).peak, seen)),
      ambient_(simplified.view.ambient * largest_component(simplified.view.ambient_color)),
      emissive_(largest_component(material_.emissive)),
      texture_(texture_bounds(simplified.texture)) {
  if (const auto* image = std::get_if<TextureImage>(&simplified.texture)) {
    texels_ = {double(image->width) * knot.repeat_u, double(image->height) * knot.repeat_v};
  }
  const Projection projection(simplified.view.camera, simplified.view.image.width,
                              simplified.view.image.height);
  const double depth = nearest_depth(seen);
  pixel_ = projection.pixel_width() * depth;
  nearest_ = std::min(depth, lights_ ? lights_->nearest : depth);
}

/// The largest change of colour if the normal turns and the point moves by these amounts.
std::optional<double> Predictor::per_pixel(double normal_turn, double offset) const {
  if (!lights_) return {};
  const double turn = normal_turn + offset / nearest_;  // directions to lamp and eye turn too
  const auto change = sum_of(lights_->diffuse, diffuse_slope(material_), lights_->specular,
                             specular_slope(material_));
  if (!change) return {};
  const double all = lights_->diffuse + lights_->specular;
  const double weakening = 2 * offset / nearest_ * all;  // of a falloff by the square
  return std::min(turn * *change + weakening, all);
}

std::optional<double> Predictor::per_vertex(const measure::Method& m) const {
  if (!lights_) return {};
  const double along = kTurn / m.segments * speed_;
  const double around = kTurn / m.sides;
  const double turn =
      std::hypot(around, along * curvature_) +
      std::hypot(along * (1 + knot_.tube_radius * curvature_), around * knot_.tube_radius) /
          nearest_;
  const auto error = [turn](auto term, auto... p) { return term.interpolation_error(turn, p...); };
  return sum_of(lights_->diffuse, with_diffuse(material_.model, material_.parameters, error),
                lights_->specular, with_highlight(material_.model, material_.parameters, error));
}

/// A weighted mean of texels is within their contrast of another. The reference's own filter at a
/// point is exact.
std::optional<double> Predictor::filter(const measure::Method& m) const {
  if (texture_.contrast == 0) return 0;
  if (m.samples == 1 && m.filter == Filter::kBilinear) return 0;
  if (material_.space != Space::kRgb || !lights_) return {};
  const double light = ambient_ + lights_->diffuse / std::max(texture_.peak, 1e-9);
  return texture_.contrast * light;
}

PredictedError Predictor::of(const measure::Method& m) const {
  const TubeSurface surface(spine_, knot_.tube_radius);
  const DeviationBound bound = deviation_bound(surface, m.segments, m.sides);
  PredictedError error;
  error.place = bound.offset / pixel_;
  if (m.number == measure::Number::kFloat)
    error.place += std::numbers::sqrt2 / 2 / fast::kSubpixels;
  error.sampling = m.samples > 1 ? 0.5 / std::sqrt(double(m.samples)) : 0;
  error.shading = m.rate == ShadingFrequency::kPixel
                      ? per_pixel(bound.normal_degrees * kTurn / 360, bound.offset)
                      : per_vertex(m);
  error.filter = filter(m);
  constexpr double kRoundings = 32;  // from the vertices to the colour
  const double own = m.number == measure::Number::kFloat ? kRounding : kRounding * kRounding;
  const double diffuse = ambient_ + (lights_ ? lights_->diffuse : 0);
  const double growth =
      with_highlight(material_.model, material_.parameters,
                     [](auto term, auto... p) { return term.rounding_growth(p...); });
  const double light = 1 + emissive_ + diffuse + (lights_ ? times(lights_->specular, growth) : 0);
  // Texture coordinates are rounded too: a part of a texel is that part of the contrast.
  const double texels = texture_.contrast * std::max(texels_.u, texels_.v) * (1 + diffuse);
  error.precision = own * (kRoundings * light + 4 * texels);
  return error;
}

}  // namespace lumaknot::plan
