/// Fixed-seed inputs for lighting formulas, the same on every machine.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "shaders/formulas/lighting.h"

namespace lumaknot {

/// Numbers and surface points from one seed. The distributions of <random> differ between
/// libraries; the generator does not.
class RandomSurface {
 public:
  explicit RandomSurface(std::uint32_t seed = 20260101) : generator_(seed) {}

  double number(double low, double high) {
    return low + (high - low) * (double(generator_()) / 4294967296.0);
  }
  Vec3d vector(double low, double high) {
    const double x = number(low, high), y = number(low, high);
    return {x, y, number(low, high)};
  }
  Vec3d direction() {
    Vec3d v = vector(-1, 1);
    while (length(v) < 0.1 || length(v) > 1) v = vector(-1, 1);
    return normalize(v);
  }
  /// An index below `count`.
  std::size_t index(std::size_t count) { return generator_() % count; }

  /// A point near the origin whose normal is up to a tenth too short, as interpolation leaves it.
  SurfacePoint<double> point() {
    const Vec3d position = vector(-1, 1);
    return {position, direction() * number(0.9, 1)};
  }
  /// T of a surface, r'g'b'.
  Vec3d texture() { return vector(0, 1); }

  /// Eye and one plain point light outside the points' cube.
  View view() {
    View view;
    view.camera.position = normalize(vector(0.1, 1)) * number(3, 6);
    const Vec3d light = normalize(vector(-1, -0.1)) * number(3, 6);
    view.lights = {PointLight{number(0, 1) < 0.5 ? light : -light, {}, {}}};
    return view;
  }

 private:
  std::mt19937 generator_;
};

/// The scene of a test: the kind of light on the surface.
struct NamedView {
  std::string name;
  View view;
};

/// One view per kind of light, plain and with all its numbers, and several lights at once.
inline std::vector<NamedView> every_view() {
  const LightColor amber{{0.9, 0.6, 0.2}, 1.5};
  const Falloff falloff{0.25, 0.125, 0.0625};
  const PointLight plain{{-2, -3, 3.5}, {}, {}}, point{{2, -1, 3}, amber, falloff};
  const DirectionalLight directional{{-0.5, 1, -2}, {{0.3, 0.5, 0.8}, 0.75}};
  const SpotLight spot{{0.5, -3, 2}, {0, 3, -2}, 10, 40, amber, falloff};
  View view;
  view.camera.position = {3, -2, 4};
  view.ambient = 0.3;
  view.ambient_color = {0.6, 0.8, 0.9};
  std::vector<NamedView> views;
  const auto add = [&](const char* name, std::vector<Light> lights) {
    view.lights = std::move(lights);
    views.push_back({name, view});
  };
  add("no light", {});
  add("plain point", {plain});
  add("plain directional", {DirectionalLight{{1, 2, -2}, {}}});
  add("point", {point});
  add("directional", {directional});
  add("spot", {spot});
  add("all kinds", {plain, point, directional, spot});
  return views;
}

}  // namespace lumaknot
