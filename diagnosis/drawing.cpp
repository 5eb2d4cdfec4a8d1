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

/// A camera at the origin along -z, a quarter turn high: what each setup's view is moved to.
const Camera kStandardCamera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90};

constexpr int kBand = 8;  // rows handed to a thread at once

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
  std::vector<Vec3d> positions;
  positions.reserve(view.mesh->positions.size());
  for (const Vec3d& p : view.mesh->positions) {
    const Vec3d v = projection.to_view(p);
    positions.push_back({scale * view.placement.scale_x * v.x + v.z * move_x / (0.5 * grid.rows),
                         scale * view.placement.scale_y * v.y - v.z * move_y / (0.5 * grid.rows),
                         v.z});
  }
  const Rasterizer rasterizer(*view.mesh, std::move(positions),
                              Projection(kStandardCamera, grid.columns, grid.rows),
                              near_depth(view.camera), grid.columns, grid.rows, kBand);
  auto result = std::make_shared<Grid<Fragment>>(grid.columns, grid.rows);
  oneapi::tbb::parallel_for(0, rasterizer.bands(), [&](int b) {
    std::ranges::copy(rasterizer.band(b).pixels, &result->at(0, kBand * b));
  });
  const std::lock_guard lock(keeping_);
  constexpr std::size_t kKept = 24;
  kept_.emplace_front(view, result);
  if (kept_.size() > kKept) kept_.pop_back();
  return result;
}

}  // namespace lumaknot::diagnosis
