#include "diagnosis/shadows.h"

#include <cmath>

#include "math/angle.h"

namespace lumaknot::diagnosis {
namespace {

constexpr int kSize = 1024;   // rows and columns of the picture that a lamp sees: only for speed
constexpr double kFar = 1e3;  // extents to a directional light's stand-in

struct Sphere {
  Vec3d centre;
  double radius = 0;
};

Sphere bounding_sphere(const TriangleMesh& mesh) {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Vec3d& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {(low + high) * 0.5, length(high - low) * 0.5};
}

Vec3d lamp_position(const lumaknot::Light& light, const Sphere& sphere) {
  if (const auto* point = std::get_if<PointLight>(&light)) return point->position;
  if (const auto* spot = std::get_if<SpotLight>(&light)) return spot->position;
  const Vec3d direction = normalize(std::get<DirectionalLight>(light).direction);
  return sphere.centre - direction * (kFar * sphere.radius);
}

/// Sees the whole sphere from `position` outside of it.
Camera lamp_camera(const Vec3d& position, const Sphere& sphere) {
  const Vec3d axis = sphere.centre - position;
  const bool steep = std::abs(axis.z) > 0.9 * length(axis);
  const double half = std::asin(sphere.radius / length(axis));
  return {position, sphere.centre, steep ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1},
          std::min(2.02 * half * kDegrees, 179.0)};
}

}  // namespace

Shadows::Shadows(const TriangleMesh& mesh, const std::vector<lumaknot::Light>& lights) {
  const Sphere sphere = bounding_sphere(mesh);
  extent_ = sphere.radius;
  for (const lumaknot::Light& light : lights) {
    const Vec3d position = lamp_position(light, sphere);
    if (length(position - sphere.centre) <= sphere.radius) {
      lamps_.push_back(nullptr);
      continue;
    }
    lamps_.push_back(
        std::make_unique<SurfaceProbe>(mesh, lamp_camera(position, sphere), kSize, kSize));
  }
}

bool Shadows::hides(std::size_t light, const Vec3d& position) const {
  if (!lamps_[light]) return false;
  const Projection& projection = lamps_[light]->rasterizer().projection();
  const Vec3d view = projection.to_view(position);
  const Vec3d point = projection.to_image(view);
  const Fragment nearest = lamps_[light]->at(point.x, point.y);
  constexpr double kBias = 1e-4;  // of the extent: the surface does not hide itself
  return nearest.covered() && nearest.depth < view.z - kBias * extent_;
}

}  // namespace lumaknot::diagnosis
