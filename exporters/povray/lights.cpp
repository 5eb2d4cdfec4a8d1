#include "exporters/povray/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exporters/povray/text.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::povray {
namespace {

/// POV-Ray's attenuation: 2 / (1 + (d / distance)^power), times `scale`.
struct Fade {
  double scale = 1, distance = 0;
  int power = 0;  ///< 0: not at all
};

/// Without a constant the distance is so small that the 1 is negligible.
Fade fade_of(const Falloff& f) {
  constexpr double kMinDistance = 1e-8;
  if (f.linear == 0 && f.quadratic == 0) return {.scale = 1 / f.constant};
  const int power = f.linear > 0 ? 1 : 2;
  const double coefficient = power == 1 ? f.linear : f.quadratic;
  const double ratio = f.constant / coefficient;
  const double distance = std::max(power == 1 ? ratio : std::sqrt(ratio), kMinDistance);
  return {1 / (2 * coefficient * std::pow(distance, power)), distance, power};
}

std::string fade_text(const Fade& fade) {
  if (fade.power == 0) return {};
  return fmt::format(" fade_distance {} fade_power {}", fade.distance, fade.power);
}

/// Prints one light of a visited variant.
struct LightText {
  Vec3d color;  ///< as the space sees it

  std::string operator()(const PointLight& light) const {
    const Fade fade = fade_of(light.falloff);
    return source(light.position, fade.scale, fade_text(fade));
  }
  /// The position of POV-Ray's parallel light does not matter.
  std::string operator()(const DirectionalLight& light) const {
    return source(-normalize(light.direction), 1, " parallel point_at 0");
  }
  /// Tightness would weaken the light within the cone.
  std::string operator()(const SpotLight& light) const {
    const Fade fade = fade_of(light.falloff);
    const Vec3d& at = light.position;
    const Vec3d aim = at + normalize(light.direction) * (1 + length(at));
    return source(
        at, fade.scale,
        fmt::format(" spotlight radius {} falloff {} tightness 0 point_at {}{}",
                    light.inner_degrees, light.outer_degrees, pov_vector(aim), fade_text(fade)));
  }

 private:
  std::string source(const Vec3d& position, double scale, const std::string& rest) const {
    return fmt::format("light_source {{ {} {}{} }}\n", pov_vector(position),
                       pov_color(color * scale), rest);
  }
};

}  // namespace

std::string pov_lights(const View& view, Space space, const Vec3d& tint) {
  Material material;
  material.space = space;
  const Lighting<double> lighting = lighting_of<double>(view, material);
  std::string text;
  for (std::size_t i = 0; i < view.lights.size(); ++i) {
    text += std::visit(LightText{modulate(lighting.lights[i].color, tint)}, view.lights[i]);
  }
  return text;
}

}  // namespace lumaknot::povray
