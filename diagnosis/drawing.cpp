#include "diagnosis/drawing.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "diagnosis/colors.h"
#include "diagnosis/filters.h"
#include "diagnosis/surface_colors.h"
#include "math/angle.h"
#include "render/projection.h"

namespace lumaknot::diagnosis {
namespace {

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.target == b.target && a.up == b.up &&
         a.fov_degrees == b.fov_degrees;
}

/// The rasteriser's camera: at the origin, along -z, a quarter turn high.
Camera standard_camera(double distance) { return {{0, 0, 0}, {0, 0, -distance}, {0, 1, 0}, 90}; }

/// The fragments' positions are of the standard camera's space: these are the world's.
void move_to_world(const TriangleMesh& mesh, Grid<Fragment>& fragments) {
  for (Fragment& f : fragments.pixels) {
    if (!f.covered()) continue;
    f.position = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[std::size_t(f.triangle)][i];
      f.position = f.position + mesh.positions[v] * f.weights[i];
    }
  }
}

void add(Drawn& sum, const Drawn& one) {
  if (sum.colors.empty()) {
    sum = one;
    return;
  }
  for (std::size_t i = 0; i < sum.colors.size(); ++i) {
    sum.colors[i] = sum.colors[i] + one.colors[i];
    sum.coverage[i] += one.coverage[i];
  }
}

void divide(Drawn& sum, double by) {
  for (Vec3d& color : sum.colors) color = color / by;
  for (double& coverage : sum.coverage) coverage /= by;
}

bool is_filtered(const PictureUse& picture) {
  return picture.blur > 0 || picture.median > 0 || picture.resampled;
}

}  // namespace

Drawer::View::View(const Setup& setup, const PixelGrid& grid, double x, double y)
    : mesh(setup.mesh),
      camera(setup.view.camera),
      placement(setup.picture.placement),
      image_height(setup.view.image.height),
      step(grid.step),
      offset_x(x),
      offset_y(y) {}

bool Drawer::View::same_as(const View& other) const {
  return mesh == other.mesh && same_camera(camera, other.camera) && placement == other.placement &&
         image_height == other.image_height && step == other.step && offset_x == other.offset_x &&
         offset_y == other.offset_y;
}

Drawn Drawer::draw(const Setup& setup) const {
  Drawn drawn = is_filtered(setup.picture) ? draw_finished(setup) : draw_samples(setup, grid_);
  apply(setup.color, drawn.colors, drawn.coverage);
  return drawn;
}

std::vector<double> Drawer::coverage(const Setup& setup) const {
  const Fragments seen = fragments(View(setup, grid_, 0, 0), grid_);
  std::vector<double> result;
  result.reserve(seen->pixels.size());
  for (const Fragment& f : seen->pixels) result.push_back(f.covered() ? 1 : 0);
  return result;
}

/// The whole picture, filtered, then its pixels on the grid.
Drawn Drawer::draw_finished(const Setup& setup) const {
  Setup unmoved = setup;
  if (setup.picture.resampled) unmoved.picture.placement = {};
  const PixelGrid all = pixel_grid(grid_.width, grid_.height, 1LL * grid_.width * grid_.height);
  return filtered(draw_samples(unmoved, all), all, setup.picture, grid_);
}

Drawn Drawer::draw_samples(const Setup& setup, const PixelGrid& grid) const {
  const PictureUse& picture = setup.picture;
  const int n = picture.samples;
  Drawn sum;
  for (int s = 0; s < n * n; ++s) {
    const auto offset = [&](int i) { return picture.filter * ((i + 0.5) / n - 0.5); };
    const View view(setup, grid, offset(s % n), offset(s / n));
    add(sum, surface_colors(setup, *fragments(view, grid)));
  }
  if (n > 1) divide(sum, double(n) * n);
  return sum;
}

Drawer::Fragments Drawer::fragments(const View& view, const PixelGrid& grid) const {
  {
    const std::lock_guard lock(keeping_);
    for (const auto& [known, fragments] : kept_) {
      if (known.same_as(view)) return fragments;
    }
  }
  const Projection projection(view.camera, grid.width, grid.height);
  const double focal = 0.5 * view.image_height / std::tan(view.camera.fov_degrees * kPi / 360);
  const double scale = focal / (0.5 * grid.rows * grid.step);
  const double move_x =
      (0.5 * grid.width + view.placement.shift_x - view.offset_x) / grid.step - 0.5 * grid.columns;
  const double move_y =
      (0.5 * grid.height + view.placement.shift_y - view.offset_y) / grid.step - 0.5 * grid.rows;
  TriangleMesh moved = *view.mesh;
  for (Vec3d& p : moved.positions) {
    const Vec3d v = projection.to_view(p);
    p = {scale * view.placement.scale_x * v.x + v.z * move_x / (0.5 * grid.rows),
         scale * view.placement.scale_y * v.y - v.z * move_y / (0.5 * grid.rows), -v.z};
  }
  const double distance = length(view.camera.position - view.camera.target);
  const Rasterizer rasterizer(moved, standard_camera(distance), grid.columns, grid.rows, 8);
  auto result = std::make_shared<Grid<Fragment>>(grid.columns, grid.rows);
  oneapi::tbb::parallel_for(0, rasterizer.bands(), [&](int b) {
    std::ranges::copy(rasterizer.band(b).pixels, &result->at(0, 8 * b));
  });
  move_to_world(*view.mesh, *result);
  const std::lock_guard lock(keeping_);
  constexpr std::size_t kKept = 24;
  kept_.emplace_front(view, result);
  if (kept_.size() > kKept) kept_.pop_back();
  return result;
}

}  // namespace lumaknot::diagnosis
