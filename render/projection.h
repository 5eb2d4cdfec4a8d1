/// From the scene to the image plane and back.
#pragma once

#include "scene/spec.h"

namespace lumaknot {

/// A camera with an image of width x height pixels: view space has x to the right, y up and z into
/// the scene; the ray through a pixel is (x, y, 1) times the depth. The number type S is double or
/// a packet of doubles.
class Projection {
 public:
  Projection(const Camera& camera, int width, int height);

  template <class S>
  Vec3<S> to_view(const Vec3<S>& world) const {
    const Vec3<S> d = world - as<S>(eye_);
    return {dot(d, as<S>(frame_.right)), dot(d, as<S>(frame_.up)), -dot(d, as<S>(frame_.back))};
  }

  /// The ray through the image point (x, y) in pixels from the top left: view space, depth one.
  Vec3d ray(double x, double y) const;

  /// A view-space direction in world space.
  Vec3d to_world(const Vec3d& direction) const;

  /// The image point of a view-space point in front of the eye; z is its depth.
  template <class S>
  Vec3<S> to_image(const Vec3<S>& view) const {
    return {S(center_x_) + S(focal_) * view.x / view.z, S(center_y_) - S(focal_) * view.y / view.z,
            view.z};
  }

  /// The width of a pixel at depth one.
  double pixel_width() const { return 1 / focal_; }

 private:
  template <class S>
  static Vec3<S> as(const Vec3d& v) {
    return {S(v.x), S(v.y), S(v.z)};
  }

  CameraFrame frame_;
  Vec3d eye_;
  double focal_, center_x_, center_y_;  // focal length and centre in pixels
};

}  // namespace lumaknot
