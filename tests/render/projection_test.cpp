#include "render/projection.h"

#include <gtest/gtest.h>

#include "math/angle.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

using testing::Random;

// A few roundings of numbers below 1000.
constexpr double kRounding = 1e-10;

TEST(Projection, image_point_and_ray_are_inverse) {
  const Camera camera{.position = {1, -3, 2}, .target = {0.5, 0, -1}, .up = {0.1, 0.2, 1}};
  const Projection projection(camera, 320, 200);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double x = random.between(-50, 400), y = random.between(-50, 300);
    const double depth = random.between(0.1, 50);
    const Vec3d image = projection.to_image(projection.ray(x, y) * depth);
    EXPECT_NEAR(image.x, x, kRounding);
    EXPECT_NEAR(image.y, y, kRounding);
    EXPECT_NEAR(image.z, depth, kRounding);
  }
}

TEST(Projection, world_point_lies_on_the_ray_through_its_image_point) {
  const Camera camera;
  const Projection projection(camera, 300, 200);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3d world = random.point(1);
    const Vec3d image = projection.to_image(projection.to_view(world));
    const Vec3d ray = testing::world_ray(camera, 300, 200, image.x, image.y);
    EXPECT_NEAR(length(camera.position + ray * image.z - world), 0, kRounding);
  }
}

TEST(Projection, target_is_at_the_centre_of_the_image_at_its_distance) {
  const Camera camera{.position = {3, 1, -2}, .target = {0.25, 7, 1}};
  const Projection projection(camera, 101, 64);
  const Vec3d image = projection.to_image(projection.to_view(camera.target));
  EXPECT_NEAR(image.x, 50.5, kRounding);
  EXPECT_NEAR(image.y, 32, kRounding);
  EXPECT_NEAR(image.z, length(camera.target - camera.position), kRounding);
}

TEST(Projection, eye_is_the_origin_of_view_space) {
  const Camera camera;
  EXPECT_EQ(Projection(camera, 8, 8).to_view(camera.position), (Vec3d{0, 0, 0}));
}

TEST(Projection, field_of_view_spans_the_height_whatever_the_width) {
  for (const double fov : {1.0, 45.0, 90.0, 170.0}) {
    for (const int width : {1, 64, 1000}) {
      Camera camera;
      camera.fov_degrees = fov;
      const Projection projection(camera, width, 64);
      const Vec3d top = projection.ray(0.5 * width, 0), bottom = projection.ray(0.5 * width, 64);
      const double angle = std::atan(top.y) - std::atan(bottom.y);
      EXPECT_NEAR(angle * 180 / kPi, fov, kRounding);
    }
  }
}

TEST(Projection, pixels_are_square) {
  const Projection projection(Camera{}, 300, 100);
  const Vec3d a = projection.ray(10, 20), b = projection.ray(11, 20), c = projection.ray(10, 21);
  EXPECT_NEAR(b.x - a.x, projection.pixel_width(), 1e-14);  // a few roundings of numbers below 1
  EXPECT_NEAR(a.y - c.y, projection.pixel_width(), 1e-14);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.x, c.x);
}

TEST(Projection, up_in_the_scene_is_up_in_the_image) {
  const Camera camera;
  const Projection projection(camera, 100, 100);
  const auto image = [&](const Vec3d& p) { return projection.to_image(projection.to_view(p)); };
  EXPECT_LT(image({0, 0, 1}).y, image({0, 0, -1}).y);  // rows grow downwards
  EXPECT_GT(image({1, 0, 0}).x, image({-1, 0, 0}).x);  // the camera looks along +y: +x is right
}

}  // namespace
}  // namespace lumaknot
