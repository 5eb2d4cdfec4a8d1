#include "validate/renderers/depth_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/angle.h"

namespace lumaknot::validate {
namespace {

/// The part of a polygon where `inside`, which is linear, is not negative.
template <class F>
std::vector<Vec3d> part_of(const std::vector<Vec3d>& polygon, const F& inside) {
  std::vector<Vec3d> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) part.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) part.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return part;
}

}  // namespace

Interval<double> depth_range(const TriangleMesh& mesh, const Camera& camera,
                             const ImageSpec& image) {
  const CameraFrame frame = camera_frame(camera);
  const double nearest = near_depth(camera);
  const double up = std::tan(camera.fov_degrees * kPi / 360);
  const double right = up * image.width / image.height;
  const std::array<Vec3d, 5> planes{Vec3d{0, 0, 1}, Vec3d{1, 0, right}, Vec3d{-1, 0, right},
                                    Vec3d{0, 1, up}, Vec3d{0, -1, up}};
  double min = INFINITY, max = 0;
  for (const Triangle& triangle : mesh.triangles) {
    std::vector<Vec3d> polygon;
    for (const std::uint32_t v : triangle) {
      const Vec3d d = mesh.positions[v] - camera.position;
      polygon.push_back({dot(d, frame.right), dot(d, frame.up), -dot(d, frame.back)});
    }
    for (std::size_t i = 0; i < planes.size() && !polygon.empty(); ++i) {
      const double least = i == 0 ? nearest : 0;
      polygon = part_of(polygon, [&](const Vec3d& p) { return dot(planes[i], p) - least; });
    }
    for (const Vec3d& corner : polygon) {
      min = std::min(min, corner.z), max = std::max(max, corner.z);
    }
  }
  const double near = std::max(nearest, min * 0.99);
  if (!std::isfinite(near)) return {nearest, 2 * nearest};  // nothing is in the view
  return {near, std::max(max * 1.01, near * 2)};
}

}  // namespace lumaknot::validate
