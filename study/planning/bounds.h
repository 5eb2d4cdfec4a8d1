/// What lights and textures can do to a colour at most.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "render/rasterizer.h"
#include "scene/scene.h"

namespace lumaknot {

LightColor& color_of(Light& light);
const LightColor& color_of(const Light& light);

/// The light's largest channel times its intensity.
double strength(const Light& light);

/// What of a light of strength one arrives at the points that are seen, and from how far.
struct Arrival {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< scene units; infinite: no lamp
};

/// Of the distance and the cone alone.
Arrival arrival_of(const View& view, std::size_t light, std::span<const Fragment> seen);

/// The most that a model's terms come to for a light of strength one; infinite without a simple
/// bound.
double most_diffuse(const Material& material);
double most_specular(const Material& material);

/// A colour changes by at most so many times what its light does; infinite where brightness is not
/// linear or a rule bends the result.
double answer(const Material& material);

/// A colour's most for a term of one; `peak`: the texture's largest channel.
double diffuse_weight(const Material& material, double peak);
double specular_weight(const Material& material);

/// 0 times what has no bound is 0.
double times(double weight, double value);

/// The most that a colour owes to all lights' diffuse terms, and to their highlights.
struct LightBounds {
  double diffuse = 0, specular = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< of all arrivals
};

/// From the least distance of each light, its cone, the weights, the texture's largest channel and
/// the model's largest value; none where that has no simple bound.
std::optional<LightBounds> light_bounds(const View& view, double peak,
                                        std::span<const Fragment> seen);

/// The largest difference of two texels, and the largest channel of one.
struct TextureBounds {
  double contrast = 0, peak = 1;
};
TextureBounds texture_bounds(const Texture& texture);

}  // namespace lumaknot
