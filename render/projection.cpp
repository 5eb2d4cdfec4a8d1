#include "render/projection.h"

#include "math/angle.h"

namespace lumaknot {

Projection::Projection(const Camera& camera, int width, int height)
    : frame_(camera_frame(camera)),
      eye_(camera.position),
      focal_(0.5 * height / std::tan(camera.fov_degrees * kPi / 360)),
      center_x_(0.5 * width),
      center_y_(0.5 * height) {}

Vec3d Projection::ray(double x, double y) const {
  return {(x - center_x_) / focal_, (center_y_ - y) / focal_, 1};
}

Vec3d Projection::to_world(const Vec3d& direction) const {
  return frame_.right * direction.x + frame_.up * direction.y - frame_.back * direction.z;
}

}  // namespace lumaknot
