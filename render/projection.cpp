#include "render/projection.h"

#include <numbers>

namespace lumaknot {

Projection::Projection(const Camera& camera, int width, int height)
    : frame_(camera_frame(camera)),
      eye_(camera.position),
      focal_(0.5 * height / std::tan(camera.fov_degrees * std::numbers::pi / 360)),
      center_x_(0.5 * width),
      center_y_(0.5 * height) {}

Vec3d Projection::to_view(const Vec3d& world) const {
  const Vec3d d = world - eye_;
  return {dot(d, frame_.right), dot(d, frame_.up), -dot(d, frame_.back)};
}

Vec3d Projection::ray(double x, double y) const {
  return {(x - center_x_) / focal_, (center_y_ - y) / focal_, 1};
}

Vec3d Projection::to_image(const Vec3d& view) const {
  return {center_x_ + focal_ * view.x / view.z, center_y_ - focal_ * view.y / view.z, view.z};
}

}  // namespace lumaknot
