/// What any point of the image sees, and all that is seen close to it.
#pragma once

#include <cstdint>
#include <vector>

#include "render/rasterizer.h"

namespace lumaknot {

/// A mesh prepared for looking at single points of the image: its triangles are sorted into tiles,
/// so a look costs as many triangles as lie near the point.
class SurfaceProbe {
 public:
  /// An image of width x height samples. Keeps `mesh` by reference.
  SurfaceProbe(const TriangleMesh& mesh, const Camera& camera, int width, int height);

  /// What the image point (x, y), in samples from the top left, sees beyond the depth `beyond`; any
  /// point inside the image.
  Fragment at(double x, double y, double beyond = 0) const;

  /// What is seen from the square of points at most `distance` samples off (x, y) in x and y: from
  /// a 5 x 5 grid of points without its centre, in which `covered()` may be false, and at the
  /// corners of each triangle's visible part, where all that is linear on a triangle is extreme.
  std::vector<Fragment> around(double x, double y, double distance) const;

  const Rasterizer& rasterizer() const { return rasterizer_; }

 private:
  const std::vector<std::uint32_t>& tile_at(double x, double y) const;
  std::vector<std::uint32_t> triangles_around(double x, double y, double distance) const;

  Rasterizer rasterizer_;
  Grid<std::vector<std::uint32_t>> tiles_;  // each in the mesh's order
};

}  // namespace lumaknot
