#include <algorithm>
#include <cmath>

#include "exporters/povray/scene.h"
#include "system/overloaded.h"

namespace lumaknot::povray {
namespace {

/// The longest side of the box about the mesh.
double extent(const TriangleMesh& mesh) {
  double longest = 0;
  for (const std::size_t axis : {0, 1, 2}) {
    const auto along = [axis](const Vec3d& p) { return components(p)[axis]; };
    const auto [low, high] = std::ranges::minmax(mesh.positions, {}, along);
    longest = std::max(longest, along(high) - along(low));
  }
  return longest;
}

void scale_falloff(Falloff& falloff, double factor) {
  falloff.linear /= factor;
  falloff.quadratic /= factor * factor;
}

void scale_light(Light& light, double factor) {
  std::visit(Overloaded{[](DirectionalLight&) {},
                        [factor](auto& lamp) {
                          lamp.position = lamp.position * factor;
                          scale_falloff(lamp.falloff, factor);
                        }},
             light);
}

}  // namespace

double pov_length_scale(const TriangleMesh& mesh) {
  constexpr double kMin = 0.01, kMax = 1e5;
  const double size = mesh.positions.empty() ? 1 : extent(mesh);
  if (!(size > 0) || !std::isfinite(size) || (size >= kMin && size <= kMax)) return 1;
  return std::exp2(-std::floor(std::log2(size)));
}

Scene scaled(Scene scene, double factor) {
  for (Vec3d& position : scene.mesh.positions) position = position * factor;
  Camera& camera = scene.view.camera;
  camera.position = camera.position * factor;
  camera.target = camera.target * factor;
  for (Light& light : scene.view.lights) scale_light(light, factor);
  return scene;
}

}  // namespace lumaknot::povray
