/// Light that weakens otherwise with distance, or comes from afar.
#include <fmt/format.h>

#include <cmath>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

std::string of(const Situation& situation, std::size_t i) {
  return situation.setup.view.lights.size() > 1 ? fmt::format(" (light {})", i + 1) : "";
}

std::string suffix(const Situation& situation, std::size_t i) {
  return situation.setup.view.lights.size() > 1 ? fmt::format("-{}", i + 1) : "";
}

/// 1 / (scale d^power): the scale is fitted, as the unit of length is.
Hypothesis weakening(const Situation& situation, std::size_t i, int power) {
  Light light = situation.setup.view.lights[i];
  const Vec3d place = *position_of(light);
  const double distance = std::max(length(place - situation.centre), 1e-9);
  const double typical = 1 / std::pow(distance, power);
  Hypothesis h = continuous(
      fmt::format("falloff-{}{}", power == 1 ? "linear" : "quadratic", suffix(situation, i)),
      Rung::kLight, {"scale", typical, 0.02 * typical, 0, 1e9},
      fmt::format("light that falls off as 1 / ({{:.4g}} d{}){}", power == 1 ? "" : "^2",
                  of(situation, i)),
      [i, power](Setup& s, double scale) {
        *falloff_of(s.view.lights[i]) = power == 1 ? Falloff{0, scale, 0} : Falloff{0, 0, scale};
      });
  h.starts = {{typical}, {1}};
  return h;
}

}  // namespace

std::vector<Hypothesis> falloff(const Situation& situation) {
  std::vector<Hypothesis> all;
  for (std::size_t i = 0; i < situation.setup.view.lights.size(); ++i) {
    Light light = situation.setup.view.lights[i];
    const Falloff* own = falloff_of(light);
    if (!own) continue;
    all.push_back(weakening(situation, i, 1));
    all.push_back(weakening(situation, i, 2));
    if (own->linear > 0 || own->quadratic > 0) {
      all.push_back(discrete("falloff-none" + suffix(situation, i), Rung::kLight,
                             "light that does not fall off with distance" + of(situation, i),
                             [i](Setup& s) { *falloff_of(s.view.lights[i]) = {}; }));
    }
    const Vec3d along = situation.centre - *position_of(light);
    const double step = 0.01 * length(along);
    if (!std::holds_alternative<PointLight>(light) || step == 0) continue;
    all.push_back({.id = "directional" + suffix(situation, i),
                   .rung = Rung::kLight,
                   .parameters = {{"x", along.x, step}, {"y", along.y, step}, {"z", along.z, step}},
                   .apply =
                       [i](Setup& s, std::span<const double> p) {
                         const LightColor color = color_of(s.view.lights[i]);
                         s.view.lights[i] = DirectionalLight{{p[0], p[1], p[2]}, color};
                       },
                   .sentence =
                       [of = of(situation, i)](std::span<const double> p) {
                         return fmt::format(
                             "a directional light along {} in place of the point light{}",
                             point(normalize(Vec3d{p[0], p[1], p[2]})), of);
                       }});
  }
  return all;
}

}  // namespace lumaknot::diagnosis
