#include <algorithm>
#include <cmath>

#include "exporters/povray/scene.h"
#include "system/overloaded.h"

namespace lumaknot::povray {
namespace {

/// The box about the mesh.
struct Box {
  Vec3d low, high;
};

Box box_about(const TriangleMesh& mesh) {
  Box box{mesh.positions.front(), mesh.positions.front()};
  for (const Vec3d& p : mesh.positions) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

double largest_size(const Vec3d& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

void scale_falloff(Falloff& falloff, double factor) {
  falloff.linear /= factor;
  falloff.quadratic /= factor * factor;
}

void place_light(Light& light, const Placement& placement) {
  std::visit(Overloaded{[](DirectionalLight&) {},
                        [&](auto& lamp) {
                          lamp.position = (lamp.position - placement.origin) * placement.scale;
                          scale_falloff(lamp.falloff, placement.scale);
                        }},
             light);
}

}  // namespace

Placement pov_placement(const TriangleMesh& mesh) {
  constexpr double kMin = 0.01, kMax = 1e5, kFar = 100;
  if (mesh.positions.empty()) return {};
  const Box box = box_about(mesh);
  const Vec3d center = (box.low + box.high) * 0.5;
  const double size = largest_size(box.high - box.low);
  if (!(size > 0) || !std::isfinite(size)) return {};
  Placement placement;
  if (largest_size(center) > kFar * size) placement.origin = center;
  if (size < kMin || size > kMax) placement.scale = std::exp2(-std::floor(std::log2(size)));
  return placement;
}

Scene placed(Scene scene, const Placement& placement) {
  if (placement == Placement{}) return scene;
  const auto place = [&](Vec3d& p) { p = (p - placement.origin) * placement.scale; };
  for (Vec3d& position : scene.mesh.positions) place(position);
  place(scene.view.camera.position);
  place(scene.view.camera.target);
  for (Light& light : scene.view.lights) place_light(light, placement);
  return scene;
}

}  // namespace lumaknot::povray
