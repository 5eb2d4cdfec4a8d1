/// Which triangle each sample sees: coverage and perspective-correct interpolation, in double.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "render/projection.h"
#include "scene/image.h"
#include "scene/spec.h"

namespace lumaknot {

/// The surface point that one sample sees.
struct Fragment {
  std::int64_t triangle = -1;  ///< -1: nothing, and the rest is zero
  double depth = 0;            ///< along the camera's axis
  Vec3d position, normal;      ///< world; the normal as interpolated
  Vec2d uv;
  std::array<double, 3> weights{};  ///< of the triangle's corners

  bool covered() const { return triangle >= 0; }
};

/// A triangle's edges as planes through the eye, in view space: the sample on the ray d lies inside
/// if dot(planes[i], d) is positive for each i; planes[i] faces corner i.
struct Edges {
  std::array<Vec3d, 3> corners;
  std::array<Vec3d, 3> planes;
  std::array<Vec3d, 3>
      doubt;             ///< the sign of dot(planes[i], d) is certain above dot(doubt[i], |d|)
  double volume = 0;     ///< of the corners' parallelepiped; 0: the triangle is not drawn
  bool swapped = false;  ///< the last two corners are exchanged, so that the volume is not negative
};

/// A mesh prepared for drawing in independent bands of rows.
///
/// Homogeneous rasterisation (Olano and Greer, Triangle Scan Conversion using 2D Homogeneous
/// Coordinates, 1997): a triangle crossing the plane of the eye needs no clipped copies. Both faces
/// of a triangle are drawn. A sample on an edge belongs to the triangle whose top or left edge it
/// is. Values too near to zero for their sign to be trusted are computed exactly, so no sample is
/// lost or drawn twice between triangles that share edges. Nothing nearer than near_depth() is
/// drawn; at equal depths the later triangle wins.
class Rasterizer {
 public:
  /// An image of width x height samples, in bands of `band_height` rows. Keeps `mesh` by reference.
  Rasterizer(const TriangleMesh& mesh, const Camera& camera, int width, int height,
             int band_height);

  /// The same with vertices in a view space of one's own, from which `projection` leads to the
  /// image; fragments are still of `mesh` in the world.
  Rasterizer(const TriangleMesh& mesh, std::vector<Vec3d> view_positions,
             const Projection& projection, double nearest, int width, int height, int band_height);

  int bands() const { return int(bins_.size()); }

  /// Rows [band * band_height, ...) of the image; the last band may have fewer.
  Grid<Fragment> band(int index) const;

  /// Samples, half open and clipped to the image.
  struct Bounds {
    int x0, x1, y0, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
  };
  /// Those whose centres lie within the triangle's bounding box made `margin` samples larger on
  /// each side.
  Bounds bounds(const Triangle& triangle, double margin = 0) const;

  Edges edges(std::uint32_t triangle) const;

  /// Replaces `seen` by what the view ray meets of the triangle, if that is not behind `seen` and
  /// its depth is at least `nearest`.
  void draw_at(std::uint32_t triangle, const Edges& edges, const Vec3d& ray, double nearest,
               Fragment& seen) const;

  /// The point of a triangle with these barycentric weights, which sum up to 1.
  Fragment fragment(std::uint32_t triangle, double depth,
                    const std::array<double, 3>& weights) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const Projection& projection() const { return projection_; }
  const Vec3d& view_position(std::uint32_t vertex) const { return view_positions_[vertex]; }
  double nearest() const { return near_; }

 private:
  void draw(std::uint32_t triangle, int first_row, Grid<Fragment>& band) const;

  const TriangleMesh& mesh_;
  Projection projection_;
  int width_, height_, band_height_;
  double near_;
  std::vector<Vec3d> view_positions_;
  std::vector<std::array<double, 2>> image_points_;  // of the vertices that are not too near
  std::vector<std::vector<std::uint32_t>> bins_;     // a band's triangles, in the mesh's order
};

}  // namespace lumaknot
