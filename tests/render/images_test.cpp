#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

Scene knot_scene(int width, int height, int samples = 1) {
  KnotSpec knot;
  knot.segments = 60;
  knot.sides = 12;
  knot.repeat_u = 12;
  Scene scene{knot_mesh(knot), bricks(), {}};
  scene.view.image = {width, height, samples};
  return scene;
}

Shot final_shot(const Scene& scene) { return {"final", Stage::kFinal, scene.view.material}; }

bool same_bytes(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(RgbaPixel)) == 0;
}

TEST(Render, background_is_black_and_transparent) {
  const Image image = render(knot_scene(40, 30));
  int background = 0;
  for (const RgbaPixel& p : image.pixels) {
    if (p.coverage > 0) continue;
    ++background;
    EXPECT_EQ(p.color, Rgb{});
  }
  EXPECT_GT(background, 100);
  EXPECT_LT(background, 1100);
}

TEST(Render, texture_stage_of_a_plain_color_is_that_color) {
  Scene scene = knot_scene(40, 30);
  scene.texture = Vec3d{0.25, 0.5, 0.75};
  const Shot shot{"texture", Stage::kTexture, {}};
  for (const RgbaPixel& p : shade_all(scene, shot, visible_fragments(scene)).pixels) {
    EXPECT_EQ(p.color, p.coverage > 0 ? (Rgb{0.25f, 0.5f, 0.75f}) : Rgb{});
  }
}

TEST(Render, equals_the_final_shot_over_the_visible_fragments) {
  for (const NamedMaterial& named : paper_materials()) {
    Scene scene = knot_scene(40, 30);
    scene.view.material = *with_formula(Material{}, named.name);
    EXPECT_TRUE(
        same_bytes(render(scene), shade_all(scene, final_shot(scene), visible_fragments(scene))))
        << named.name;
  }
}

/// The average of each n x n block of pixels.
Image box_average(const Image& large, int n) {
  Image image(large.width / n, large.height / n);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Vec3d sum;
      double coverage = 0;
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          sum = sum + to_vec(large.at(n * x + i, n * y + j).color);
          coverage += large.at(n * x + i, n * y + j).coverage;
        }
      }
      image.at(x, y) = {to_rgb(sum / (double(n) * n)), float(coverage / (double(n) * n))};
    }
  }
  return image;
}

TEST(Render, samples_average_the_image_that_many_times_larger) {
  for (const int n : {2, 3, 5, 20}) {  // 20: a band holds a single row of pixels
    const Image image = render(knot_scene(13, 9, n));
    const Scene large = knot_scene(13 * n, 9 * n);
    const Image expected =
        box_average(shade_all(large, final_shot(large), visible_fragments(large)), n);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const RgbaPixel &a = image.pixels[i], &b = expected.pixels[i];
      // The larger image was rounded to float first: half a unit of 2^-23 for values up to 2.
      EXPECT_NEAR(length(to_vec(a.color) - to_vec(b.color)), 0, 5e-7) << n;
      EXPECT_EQ(a.coverage, b.coverage) << n;
    }
  }
}

TEST(Render, is_the_same_bytes_every_time_and_on_any_number_of_threads) {
  const Scene scene = knot_scene(50, 41, 2);
  const Image image = render(scene);
  EXPECT_TRUE(same_bytes(render(scene), image));
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            threads);
    EXPECT_TRUE(same_bytes(render(scene), image)) << threads;
  }
}

TEST(Render, reports_progress_that_grows_to_one) {
  std::vector<double> shares;
  render(knot_scene(20, 100), [&](double share) { shares.push_back(share); });
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
}

TEST(Render, draws_images_of_one_pixel_and_of_one_column) {
  for (const auto& [width, height] : {std::array{1, 1}, {1, 40}, {40, 1}}) {
    const Image image = render(knot_scene(width, height, 3));
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.pixels.size(), std::size_t(width * height));
  }
}

TEST(Compose, our_own_stages_give_the_final_image_for_every_material) {
  for (const NamedMaterial& named : paper_materials()) {
    Scene scene = knot_scene(64, 48);
    scene.view.material = *with_formula(Material{}, named.name);
    scene.view.material.normal = NormalUse::kUnit;
    const Grid<Fragment> fragments = visible_fragments(scene);
    const auto stage = [&](Stage s) {
      return shade_all(scene, {"stage", s, scene.view.material}, fragments);
    };
    const Image composed = compose(scene, final_shot(scene), stage(Stage::kTexture),
                                   stage(Stage::kDiffuse), stage(Stage::kSpecular));
    const Image expected = render(scene);
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
      // Each stage was rounded to float: 6e-8 for values up to one, weighed by factors up to 2.
      EXPECT_NEAR(length(to_vec(composed.pixels[i].color) - to_vec(expected.pixels[i].color)), 0,
                  1e-6)
          << named.name;
      EXPECT_EQ(composed.pixels[i].coverage, expected.pixels[i].coverage);
    }
  }
}

TEST(Compose, leaves_the_background_black_whatever_the_offset) {
  Scene scene = knot_scene(2, 1);
  Shot shot = final_shot(scene);
  shot.material = *with_formula(Material{}, "yiq-table1");  // with a luma offset
  const Image nothing(2, 1);
  for (const RgbaPixel& p : compose(scene, shot, nothing, nothing, nothing).pixels) {
    EXPECT_EQ(p.color, Rgb{});
    EXPECT_EQ(p.coverage, 0);
  }
}

}  // namespace
}  // namespace lumaknot
