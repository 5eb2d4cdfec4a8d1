#include "diagnosis/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/reference.h"
#include "tests/diagnosis/small_case.h"

namespace lumaknot::diagnosis {
namespace {

using testing::own_picture;
using testing::small_case;

Setup setup_of(const Scene& scene) {
  Setup setup;
  setup.mesh = std::make_shared<const TriangleMesh>(scene.mesh);
  setup.texture = std::make_shared<const Texture>(scene.texture);
  setup.view = scene.view;
  return setup;
}

double largest_error(const Drawn& drawn, const PixelGrid& grid, const Image& image) {
  double largest = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const RgbaPixel& p = image.at(grid.x(i), grid.y(i));
    largest = std::max(largest, largest_magnitude(drawn.colors[i] - to_vec(p.color)));
    largest = std::max(largest, std::abs(drawn.coverage[i] - double(p.coverage)));
  }
  return largest;
}

TEST(PixelGrid, is_the_finest_with_an_odd_step_that_has_no_more_pixels) {
  const PixelGrid grid = pixel_grid(720, 720, 24'000);
  EXPECT_EQ(grid.step, 5);
  EXPECT_EQ(grid.size(), 144u * 144u);
  EXPECT_EQ(grid.x(0), 2);
  EXPECT_EQ(grid.y(grid.size() - 1), 717);
}

TEST(PixelGrid, of_a_small_picture_has_all_of_its_pixels) {
  const PixelGrid grid = pixel_grid(30, 20, 600);
  EXPECT_EQ(grid.size(), 600u);
  EXPECT_EQ(grid.x(31), 1);
  EXPECT_EQ(grid.y(31), 1);
}

// The drawer's rays go through the same points by another road: 1e-6 is what a texture's steep
// edges make of 1e-12 of a pixel, rounded to float.
TEST(Drawer, draws_the_reference_at_every_pixel) {
  const Scene scene = small_case();
  const Drawer drawer(pixel_grid(96, 72, 1 << 20));
  EXPECT_LT(largest_error(drawer.draw(setup_of(scene)), drawer.grid(), own_picture(scene)), 1e-6);
}

TEST(Drawer, draws_the_reference_at_every_third_pixel) {
  const Scene scene = small_case();
  const Drawer drawer(pixel_grid(96, 72, 96 * 72 / 9));
  ASSERT_EQ(drawer.grid().step, 3);
  EXPECT_LT(largest_error(drawer.draw(setup_of(scene)), drawer.grid(), own_picture(scene)), 1e-6);
}

TEST(Drawer, draws_several_samples_per_pixel_as_the_reference) {
  Scene scene = small_case();
  scene.view.image.samples = 3;
  auto setup = setup_of(scene);
  setup.picture.samples = 3;
  const Drawer drawer(pixel_grid(96, 72, 1 << 20));
  EXPECT_LT(largest_error(drawer.draw(setup), drawer.grid(), render(scene)), 1e-6);
}

TEST(Drawer, moves_a_picture_by_whole_pixels_as_its_camera_or_as_a_finished_picture) {
  const Scene scene = small_case();
  auto setup = setup_of(scene);
  setup.picture.placement.shift_x = 2;
  const Drawer drawer(pixel_grid(96, 72, 1 << 20));
  const Drawn by_camera = drawer.draw(setup);
  setup.picture.resampled = true;
  const Drawn finished = drawer.draw(setup);
  const Image own = own_picture(scene);
  for (int y = 0; y < 72; ++y) {
    for (int x = 2; x < 96; ++x) {
      const std::size_t i = std::size_t(y) * 96 + std::size_t(x);
      const Vec3d expected = to_vec(own.at(x - 2, y).color);
      EXPECT_LT(largest_magnitude(by_camera.colors[i] - expected), 1e-6);
      EXPECT_LT(largest_magnitude(finished.colors[i] - expected), 1e-6);
    }
  }
}

TEST(Drawer, mirrors_a_picture) {
  const Scene scene = small_case();
  auto setup = setup_of(scene);
  setup.picture.placement.scale_x = -1;
  const Drawer drawer(pixel_grid(96, 72, 1 << 20));
  const Drawn drawn = drawer.draw(setup);
  const Image own = own_picture(scene);
  double largest = 0;
  for (std::size_t i = 0; i < drawer.grid().size(); ++i) {
    const int x = drawer.grid().x(i), y = drawer.grid().y(i);
    const Vec3d expected = to_vec(own.at(95 - x, y).color);
    largest = std::max(largest, largest_magnitude(drawn.colors[i] - expected));
  }
  EXPECT_LT(largest, 1e-6);
}

}  // namespace
}  // namespace lumaknot::diagnosis
