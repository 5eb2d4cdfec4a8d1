// What must not matter to the fast renderer, and what it must survive.
#include <gtest/gtest.h>

#include "system/error.h"
#include "tests/render/fast/allocations.h"
#include "tests/render/fast/testing.h"

namespace lumaknot::fast {
namespace {

using testing::Difference;
using testing::difference;
using testing::fast_image;
using testing::knot_scene;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const Scene& scene, const Options& options) {
  try {
    Renderer(scene, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(FastLimits, the_number_of_threads_does_not_matter) {
  const Scene scene = knot_scene(150, 200, 20);
  for (const int samples : {1, 8}) {
    Options options;
    options.samples = samples;
    options.threads = 1;
    const Image one = fast_image(scene, options);
    for (const int threads : {2, 3, 7}) {
      options.threads = threads;
      const Image many = fast_image(scene, options);
      for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        ASSERT_EQ(one.pixels[i].color, many.pixels[i].color) << i;
        ASSERT_EQ(one.pixels[i].coverage, many.pixels[i].coverage) << i;
      }
    }
  }
}

TEST(FastLimits, sets_of_instructions_agree_to_a_255th) {
  for (const int samples : {1, 8}) {
    Options options;
    options.samples = samples;
    options.filter = Filter::kTrilinear;
    options.level = SimdLevel::kBaseline;
    const Image base = fast_image(knot_scene(), options);
    for (const SimdLevel level : testing::simd_levels()) {
      options.level = level;
      const Difference d = difference(base, fast_image(knot_scene(), options));
      EXPECT_EQ(d.coverage, 0);
      EXPECT_LE(d.max, 1.0 / 255);
    }
  }
}

TEST(FastLimits, a_frame_after_the_first_allocates_nothing) {
  const Scene scene = knot_scene();
  for (const int samples : {1, 8}) {
    Options options;
    options.samples = samples;
    options.threads = 2;
    Renderer renderer(scene, options);
    Grid<Rgba8> bytes;
    renderer.draw(bytes);
    const long before = testing::allocations();
    for (int i = 0; i < 5; ++i) renderer.draw(bytes);
    EXPECT_EQ(testing::allocations(), before);
  }
}

TEST(FastLimits, frames_with_clipped_triangles_allocate_nothing_either) {
  Scene scene = knot_scene();
  scene.view.camera.position = scene.mesh.positions[0];
  Renderer renderer(scene, {});
  Grid<Rgba8> bytes;
  renderer.draw(bytes);
  renderer.draw(bytes);
  const long before = testing::allocations();
  renderer.draw(bytes);
  EXPECT_EQ(testing::allocations(), before);
}

TEST(FastLimits, an_eye_inside_the_tube_sees_its_inside) {
  Scene scene = knot_scene();
  const std::size_t columns = 13;
  Vec3d centre;
  for (std::size_t j = 0; j + 1 < columns; ++j) centre = centre + scene.mesh.positions[j] / 12.0;
  scene.view.camera.position = centre;
  const Image reference = render(scene), fast = fast_image(scene);
  const Difference d = difference(reference, fast);
  EXPECT_LE(d.coverage,
            4);  // some pixels at the near plane, which is cut before points are snapped
  EXPECT_GT(d.covered, 9000);
  int differing = 0;
  for (std::size_t i = 0; i < fast.pixels.size(); ++i) {
    differing += std::abs(fast.pixels[i].color.r - reference.pixels[i].color.r) > 1.0 / 255;
  }
  EXPECT_LE(differing, 20);
}

TEST(FastLimits, an_eye_that_looks_away_sees_nothing) {
  Scene scene = knot_scene();
  scene.view.camera.target = scene.view.camera.position * 2;
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    for (const RgbaPixel& p : fast_image(scene, options).pixels) ASSERT_EQ(p.coverage, 0);
  }
}

// Half of the knot is behind the eye, and packets hold triangles of all kinds.
TEST(FastLimits, an_eye_in_the_middle_of_a_knot_draws_what_the_reference_does) {
  Scene scene = knot_scene();
  scene.view.camera.position = {0.5, -0.5, 0.5};
  scene.view.camera.target = {-1, 1, -0.2};
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    const Difference d = difference(render(scene), fast_image(scene, options));
    EXPECT_LE(d.coverage, 2);
    EXPECT_GT(d.covered, 1000);
    EXPECT_LE(d.max, 1.0 / 255);
  }
}

// Beyond 1.8e19 the square of a distance overflows single precision.
TEST(FastLimits, lamps_far_away_shine_as_the_reference_has_them) {
  for (const double distance : {1e14, 1e16, 1e20, 1e25}) {
    SCOPED_TRACE(distance);
    Scene scene = knot_scene();
    PointLight lamp{Vec3d{1, -1, 1} * distance, {{1, 0.8, 0.6}, 0.7}, {0.5, 0, 0}};
    lamp.falloff.quadratic = 0.1 / distance / distance;
    SpotLight spot{Vec3d{-1, -1, 1} * distance, {1, 1, -1}, 10, 40, {{1, 1, 1}, 0.5}, {}};
    scene.view.lights = {lamp, spot};
    const Difference d = difference(render(scene), fast_image(scene));
    EXPECT_LE(d.coverage, 2);
    EXPECT_LE(d.max, 1.0 / 255);
  }
}

TEST(FastLimits, an_eye_on_a_vertex_draws_what_the_reference_does) {
  Scene scene = knot_scene();
  scene.view.camera.position = scene.mesh.positions[40];
  const Difference d = difference(render(scene), fast_image(scene));
  EXPECT_LE(d.coverage, 4);
}

TEST(FastLimits, vertices_that_are_no_numbers_draw_nothing_and_leave_the_rest) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    Scene scene = knot_scene();
    scene.mesh.positions[100].y = bad;
    const Difference d = difference(render(scene), fast_image(scene));
    EXPECT_LE(d.coverage, 2);
    EXPECT_LE(d.max, 1.0 / 255);
  }
}

TEST(FastLimits, triangles_without_area_draw_nothing) {
  Scene scene = knot_scene();
  scene.mesh.triangles.clear();
  for (std::uint32_t i = 0; i < 60; ++i) {
    scene.mesh.triangles.push_back({i, i, i + 1});
    scene.mesh.triangles.push_back({i, i, i});
  }
  for (const RgbaPixel& p : fast_image(scene).pixels) ASSERT_EQ(p.coverage, 0);
  scene.mesh.triangles.clear();
  for (const RgbaPixel& p : fast_image(scene).pixels) ASSERT_EQ(p.coverage, 0);
}

TEST(FastLimits, huge_triangles_are_drawn) {
  for (const double size : {1e3, 1e6, 1e9, 1e15}) {
    SCOPED_TRACE(size);
    Scene scene{{}, Vec3d{0.5, 0.5, 0.5}, {}};
    testing::add_triangle(scene.mesh, {-size, -size, 0}, {size, -size, 0.25 * size},
                          {0.1 * size, size, -0.125 * size});
    scene.view.image = {64, 64, 1};
    const Difference d = difference(render(scene), fast_image(scene));
    EXPECT_LE(d.coverage, 4);
    EXPECT_GT(d.covered, 100);
  }
}

TEST(FastLimits, what_it_can_not_draw_is_refused) {
  const Scene scene = knot_scene();
  for (const int samples : {0, 3, 17, -1}) {
    Options options;
    options.samples = samples;
    EXPECT_EQ(refusal(scene, options),
              "--multisample must be 1, 2, 4, 6, 8 or 16, got " + std::to_string(samples));
  }
  Scene wide = scene;
  wide.view.image = {16385, 4, 1};
  EXPECT_EQ(refusal(wide, {}), "image must be at most 16384 x 16384 here, got 16385 x 4");
  Scene long_texture = scene;
  long_texture.texture = TextureImage(16385, 1);
  EXPECT_EQ(refusal(long_texture, {}), "texture must be at most 16384 x 16384 here, got 16385 x 1");
  Scene fine = scene;
  fine.view.image.samples = 2;
  EXPECT_EQ(refusal(fine, {}), "image.samples must be 1 here, got 2; use --multisample 4 instead");
}

}  // namespace
}  // namespace lumaknot::fast
