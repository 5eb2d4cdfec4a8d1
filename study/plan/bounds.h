/// Upper bounds of the effect of lights and textures on a colour.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "render/rasterizer.h"
#include "scene/spec.h"

namespace lumaknot::plan {

LightColor& color_of(Light& light);
const LightColor& color_of(const Light& light);

/// The light's largest channel times its intensity.
double strength(const Light& light);

/// The share of a light of strength one that arrives at the visible points, and from how far.
struct Arrival {
  double min = std::numeric_limits<double>::infinity(), max = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< scene units; infinite: no lamp
};

/// From the distance and the cone only.
Arrival arrival_of(const View& view, std::size_t light, std::span<const Fragment> seen);

/// The maxima of a model's terms for a light of strength one; infinite without a simple bound.
double max_diffuse(const Material& material);
double max_specular(const Material& material);

/// The largest change of a colour per change of its light; infinite if brightness is not linear or
/// a rule bends the result.
double sensitivity(const Material& material);

/// A colour's maximum for a term of one; `peak`: the texture's largest channel.
double diffuse_weight(const Material& material, double peak);
double specular_weight(const Material& material);

/// 0 times infinity is 0.
double times(double weight, double value);

/// The largest contribution of all lights' diffuse terms to a colour, and of their highlights.
struct LightBounds {
  double diffuse = 0, specular = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< of all arrivals
};

/// From the smallest distance of each light, its cone, the weights, the texture's largest channel
/// and the model's largest value; empty without a simple bound.
std::optional<LightBounds> light_bounds(const View& view, double peak,
                                        std::span<const Fragment> seen);

/// The largest difference of two texels, and the largest channel of one.
struct TextureBounds {
  double contrast = 0, peak = 1;
};
TextureBounds texture_bounds(const Texture& texture);

}  // namespace lumaknot::plan
