// Pictures through a filter, against a box of as many samples and against what is known exactly.
#include "render/filtered.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/validate/small_scene.h"

namespace lumaknot {
namespace {

double box(double offset) { return std::abs(offset) < 0.5 ? 1 : 0; }
double far_up_and_right(double offset) { return offset > 0.5 && offset < 1.5 ? 1 : 0; }

Shot own_shot(const Scene& scene) { return {"final", Stage::kFinal, scene.view.material}; }

double channel(const RgbaPixel& pixel, std::size_t c) {
  return std::array{pixel.color.r, pixel.color.g, pixel.color.b, pixel.coverage}[c];
}

TEST(Filtered, a_box_gives_the_mean_of_a_pixels_samples) {
  Scene scene = testing::small_scene(48);
  const FilteredImage filtered = render_filtered(scene, own_shot(scene), {box, 0.5}, 1024);
  scene.view.image.samples = 32;
  const Image samples = render(scene);
  for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      const double a = filtered.halves[0].pixels[i][c], b = filtered.halves[1].pixels[i][c];
      EXPECT_NEAR(a, b, 0.03) << "edges of two sets of 512 samples";
      EXPECT_NEAR((a + b) / 2, channel(samples.pixels[i], c), 0.02) << i << ", channel " << c;
    }
  }
}

TEST(Filtered, a_filter_that_lies_a_pixel_up_and_right_moves_the_picture) {
  const Scene scene = testing::small_scene(32);
  const FilteredImage middle = render_filtered(scene, own_shot(scene), {box, 0.5}, 128);
  const FilteredImage moved = render_filtered(scene, own_shot(scene), {far_up_and_right, 1.5}, 128);
  for (int y = 1; y < 32; ++y) {
    for (int x = 0; x < 31; ++x) {
      EXPECT_NEAR(moved.halves[0].at(x, y)[1], middle.halves[0].at(x + 1, y - 1)[1], 1e-12);
    }
  }
}

TEST(Filtered, spread_and_reach_are_those_of_samples) {
  const Scene scene = testing::small_scene(48);
  const FilteredImage image = render_filtered(scene, own_shot(scene), {box, 0.5}, 128);
  int edges = 0;
  for (std::size_t i = 0; i < image.spread.pixels.size(); ++i) {
    const double coverage = (image.halves[0].pixels[i][3] + image.halves[1].pixels[i][3]) / 2;
    EXPECT_NEAR(image.spread.pixels[i][3], std::sqrt(coverage * std::abs(1 - coverage)), 1e-6);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_LE(image.spread.pixels[i][c], image.reach.pixels[i][c] + 1e-12);
      if (coverage == 0) {
        EXPECT_EQ(image.reach.pixels[i][c], 0);
      }
    }
    edges += coverage > 0.1 && coverage < 0.9;
  }
  EXPECT_GT(edges, 50);
}

}  // namespace
}  // namespace lumaknot
