#include "study/plan/bounds.h"

#include <algorithm>
#include <cmath>

#include "shaders/formulas/lighting.h"

namespace lumaknot::plan {
namespace {

/// With its arrival reduced only by the distance and the cone.
LightNumbers<double> uncolored(const View& view, std::size_t i) {
  LightNumbers<double> light = lighting_of<double>(view, view.material).lights[i];
  light.color = {1, 1, 1};
  return light;
}

}  // namespace

LightColor& color_of(Light& light) {
  return std::visit([](auto& l) -> LightColor& { return l.color; }, light);
}
const LightColor& color_of(const Light& light) {
  return std::visit([](const auto& l) -> const LightColor& { return l.color; }, light);
}

double strength(const Light& light) {
  return color_of(light).intensity * largest_component(color_of(light).rgb);
}

Arrival arrival_of(const View& view, std::size_t i, std::span<const Fragment> seen) {
  const LightNumbers<double> light = uncolored(view, i);
  Arrival arrival;
  for (const Fragment& point : seen) {
    const Vec3d to_light =
        light.has_position ? light.position - point.position : light.direction * -1.0;
    const double part = arriving<double>(light, to_light, unit(to_light)).x;
    arrival.min = std::min(arrival.min, part);
    arrival.max = std::max(arrival.max, part);
    if (light.has_position) arrival.nearest = std::min(arrival.nearest, length(to_light));
  }
  return arrival;
}

double max_diffuse(const Material& m) {
  return with_diffuse(m.model, m.parameters,
                      [](auto term, auto... p) { return term.largest(p...); });
}

double max_specular(const Material& m) {
  return with_highlight(m.model, m.parameters,
                        [](auto term, auto... p) { return term.largest(p...); });
}

double sensitivity(const Material& m) {
  const bool plain = m.space == Space::kRgb || is_linear(m.space);
  return plain && m.gamut != Gamut::kChroma ? 1 : std::numeric_limits<double>::infinity();
}

double diffuse_weight(const Material& m, double peak) {
  return sensitivity(m) * m.diffuse * largest_component(m.diffuse_color) * peak;
}

double specular_weight(const Material& m) {
  return sensitivity(m) * m.specular * largest_component(m.specular_color);
}

double times(double weight, double value) { return weight == 0 ? 0 : weight * value; }

std::optional<LightBounds> light_bounds(const View& view, double peak,
                                        std::span<const Fragment> seen) {
  const Material& m = view.material;
  const double diffuse = times(diffuse_weight(m, peak), max_diffuse(m));
  const double specular = times(specular_weight(m), max_specular(m));
  LightBounds bounds;
  for (std::size_t i = 0; i < view.lights.size(); ++i) {
    const Arrival arrival = arrival_of(view, i, seen);
    const double arrives = strength(view.lights[i]) * arrival.max;
    bounds.nearest = std::min(bounds.nearest, arrival.nearest);
    bounds.diffuse += times(arrives, diffuse);
    bounds.specular += times(arrives, specular);
  }
  if (!std::isfinite(bounds.diffuse + bounds.specular)) return {};
  return bounds;
}

TextureBounds texture_bounds(const Texture& texture) {
  if (const auto* color = std::get_if<Vec3d>(&texture)) return {0, largest_component(*color)};
  Rgb min{1, 1, 1}, max;
  for (const Rgb& c : std::get<TextureImage>(texture).pixels) {
    min = {std::min(min.r, c.r), std::min(min.g, c.g), std::min(min.b, c.b)};
    max = {std::max(max.r, c.r), std::max(max.g, c.g), std::max(max.b, c.b)};
  }
  return {largest_component(to_vec(max) - to_vec(min)), largest_component(to_vec(max))};
}

}  // namespace lumaknot::plan
