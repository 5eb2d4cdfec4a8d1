/// Draws a setup at the pixels of a grid, hundreds of times a second.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "diagnosis/pixel_grid.h"
#include "diagnosis/setup.h"
#include "render/rasterizer.h"

namespace lumaknot::diagnosis {

/// The pixels of a grid, in its order.
struct Drawn {
  std::vector<Vec3d> colors;     ///< over black
  std::vector<double> coverage;  ///< in [0, 1]
};

/// Draws; what the same camera sees of the same mesh is kept for the next setups. May be used by
/// several threads.
class Drawer {
 public:
  explicit Drawer(const PixelGrid& grid) : grid_(grid) {}

  const PixelGrid& grid() const { return grid_; }
  Drawn draw(const Setup& setup) const;
  /// The coverage alone of one sample per pixel.
  std::vector<double> coverage(const Setup& setup) const;

 private:
  /// All that decides which point of the surface a pixel sees.
  struct View {
    std::shared_ptr<const TriangleMesh> mesh;
    Camera camera;
    Placement placement;
    int image_height = 0;
    int step = 1;
    double offset_x = 0, offset_y = 0;  ///< of the sample from the pixel's centre, pixels
    View(const Setup& setup, const PixelGrid& grid, double x, double y);
    bool same_as(const View& other) const;
  };
  using Fragments = std::shared_ptr<const Grid<Fragment>>;

  Drawn draw_finished(const Setup& setup) const;
  Drawn draw_samples(const Setup& setup, const PixelGrid& grid) const;
  Fragments fragments(const View& view, const PixelGrid& grid) const;

  PixelGrid grid_;
  mutable std::mutex keeping_;
  mutable std::list<std::pair<View, Fragments>> kept_;
};

}  // namespace lumaknot::diagnosis
