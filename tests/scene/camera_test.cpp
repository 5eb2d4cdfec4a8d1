#include <gtest/gtest.h>

#include "scene/spec.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;  // a handful of operations on numbers near one

const Camera kCameras[] = {
    Camera{},
    {{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 45},
    {{3, 4, 12}, {-1, 0.5, 2}, {0.2, -0.3, 7}, 20},
    {{1e6, -2e6, 3e5}, {0, 0, 0}, {0, 1, 0}, 100},
    {{1e-6, 2e-6, 0}, {0, 0, 0}, {0, 0, 1e-5}, 10},
};

TEST(CameraFrame, is_orthonormal_and_right_handed) {
  for (const Camera& camera : kCameras) {
    const CameraFrame frame = camera_frame(camera);
    EXPECT_NEAR(length(frame.right), 1, kRounding);
    EXPECT_NEAR(length(frame.up), 1, kRounding);
    EXPECT_NEAR(length(frame.back), 1, kRounding);
    EXPECT_NEAR(dot(frame.right, frame.up), 0, kRounding);
    EXPECT_NEAR(dot(frame.up, frame.back), 0, kRounding);
    EXPECT_NEAR(dot(frame.back, frame.right), 0, kRounding);
    EXPECT_NEAR(dot(cross(frame.right, frame.up), frame.back), 1, kRounding);
  }
}

TEST(CameraFrame, looks_at_the_target) {
  for (const Camera& camera : kCameras) {
    const Vec3d sight = camera.target - camera.position;
    const CameraFrame frame = camera_frame(camera);
    EXPECT_NEAR(dot(sight, -frame.back) / length(sight), 1, kRounding);
    EXPECT_NEAR(dot(sight, frame.right) / length(sight), 0, kRounding);
    EXPECT_NEAR(dot(sight, frame.up) / length(sight), 0, kRounding);
  }
}

TEST(CameraFrame, shows_up_upwards_and_never_sideways) {
  for (const Camera& camera : kCameras) {
    const CameraFrame frame = camera_frame(camera);
    EXPECT_GT(dot(camera.up, frame.up), 0);
    EXPECT_NEAR(dot(camera.up, frame.right) / length(camera.up), 0, kRounding);
  }
}

TEST(CameraFrame, has_x_to_the_right_when_looking_along_y) {
  const CameraFrame frame = camera_frame({{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 45});
  EXPECT_EQ(frame.right, (Vec3d{1, 0, 0}));
  EXPECT_EQ(frame.up, (Vec3d{0, 0, 1}));
  EXPECT_EQ(frame.back, (Vec3d{0, -1, 0}));
}

TEST(NearDepth, is_a_thousandth_of_the_distance_to_the_target) {
  EXPECT_DOUBLE_EQ(near_depth({{0, 0, 7}, {0, 3, 3}, {0, 1, 0}, 45}), 0.005);
}

TEST(Vec3, cross_product_is_right_handed) {
  EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
  EXPECT_EQ(cross(Vec3d{0, 1, 0}, Vec3d{0, 0, 1}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(cross(Vec3d{1, 2, 3}, Vec3d{1, 2, 3}), (Vec3d{0, 0, 0}));
}

TEST(Vec3, is_finite_only_with_three_finite_components) {
  EXPECT_TRUE(is_finite({1, 2, 3}));
  EXPECT_FALSE(is_finite({INFINITY, 2, 3}));
  EXPECT_FALSE(is_finite({1, NAN, 3}));
  EXPECT_FALSE(is_finite({1, 2, -INFINITY}));
}

TEST(Grid, is_stored_row_by_row_from_the_top_left) {
  Grid<int> grid(3, 2);
  grid.at(2, 0) = 7;
  grid.at(0, 1) = 9;
  EXPECT_EQ(grid.pixels, (std::vector<int>{0, 0, 7, 9, 0, 0}));
}

}  // namespace
}  // namespace lumaknot
