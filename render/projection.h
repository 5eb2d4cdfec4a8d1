/// From the scene to the image plane and back.
#pragma once

#include "scene/scene.h"

namespace lumaknot {

/// A camera with an image of width x height pixels: view space has x to the right, y up and z into
/// the scene; the ray through a pixel is (x, y, 1) times the depth.
class Projection {
 public:
  Projection(const Camera& camera, int width, int height);

  Vec3d to_view(const Vec3d& world) const;

  /// The ray through the image point (x, y) in pixels from the top left: view space, depth one.
  Vec3d ray(double x, double y) const;

  /// The image point of a view-space point in front of the eye; z is its depth.
  Vec3d to_image(const Vec3d& view) const;

  /// The width of a pixel at depth one.
  double pixel_width() const { return 1 / focal_; }

 private:
  CameraFrame frame_;
  Vec3d eye_;
  double focal_, center_x_, center_y_;  // focal length and centre in pixels
};

}  // namespace lumaknot
