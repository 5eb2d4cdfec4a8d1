#include "shaders/spaces/yiq.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lumaknot {
namespace {

constexpr double kPrintedDigits = 1e-7;  // eight decimals, a sum of three products of up to 1.7

Yiq<double> yiq(const Vec3d& rgb) { return yiq_from_rgb<double>(rgb); }

std::vector<Vec3d> cube_corners() {
  std::vector<Vec3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  return corners;
}

TEST(Yiq, m_and_w_are_inverse_to_each_other_up_to_their_printed_digits) {
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
    EXPECT_LT(length(rgb_from_yiq(yiq(axis)) - axis), kPrintedDigits);
    const Yiq<double> back = yiq(rgb_from_yiq(Yiq<double>{axis.x, axis.y, axis.z}));
    EXPECT_LT(length(Vec3d{back.y, back.i, back.q} - axis), kPrintedDigits);
  }
}

TEST(Yiq, colours_survive_the_round_trip) {
  for (const Vec3d& corner : cube_corners()) {
    const Vec3d color = corner * 0.7 + Vec3d{0.1, 0.2, 0.05};
    EXPECT_LT(length(rgb_from_yiq(yiq(color)) - color), kPrintedDigits);
  }
}

TEST(Yiq, fills_the_paper_s_ranges_over_the_rgb_cube) {
  // All three are linear, so corners of the cube hold the extremes.
  std::vector<double> y, i, q;
  for (const Vec3d& corner : cube_corners()) {
    y.push_back(yiq(corner).y);
    i.push_back(yiq(corner).i);
    q.push_back(yiq(corner).q);
  }
  const auto [y_min, y_max] = std::ranges::minmax(y);
  const auto [i_min, i_max] = std::ranges::minmax(i);
  const auto [q_min, q_max] = std::ranges::minmax(q);
  EXPECT_EQ(y_min, 0);
  EXPECT_NEAR(y_max, 1, kPrintedDigits);
  // The paper prints four digits, the last of I's cut from 0.59598 to the standard's 0.5957.
  EXPECT_NEAR(i_max, 0.5957, 3e-4);
  EXPECT_NEAR(i_min, -0.5957, 3e-4);
  EXPECT_NEAR(q_max, 0.5226, 1e-4);
  EXPECT_NEAR(q_min, -0.5226, 1e-4);
}

TEST(Yiq, greys_have_no_chroma) {
  for (const double grey : {0.0, 0.25, 1.0}) {
    EXPECT_NEAR(yiq({grey, grey, grey}).y, grey, kPrintedDigits);
    EXPECT_NEAR(yiq({grey, grey, grey}).i, 0, kPrintedDigits);
    EXPECT_NEAR(yiq({grey, grey, grey}).q, 0, kPrintedDigits);
  }
}

TEST(Yiq, green_is_the_lightest_primary_and_blue_the_darkest) {
  EXPECT_GT(yiq({0, 1, 0}).y, yiq({1, 0, 0}).y);
  EXPECT_GT(yiq({1, 0, 0}).y, yiq({0, 0, 1}).y);
}

TEST(Yiq, i_runs_from_orange_to_cyan_and_q_from_purple_to_green) {
  EXPECT_GT(yiq({1, 0.5, 0}).i, 0.3);
  EXPECT_LT(yiq({0, 1, 1}).i, -0.5);
  EXPECT_GT(yiq({1, 0, 1}).q, 0.5);
  EXPECT_LT(yiq({0, 1, 0}).q, -0.5);
}

TEST(Yiq, luma_moves_every_channel_alike) {
  const Vec3d low = rgb_from_yiq(Yiq<double>{0.25, 0.1, -0.2});
  const Vec3d high = rgb_from_yiq(Yiq<double>{0.75, 0.1, -0.2});
  EXPECT_LT(length(high - low - Vec3d{0.5, 0.5, 0.5}), 1e-15);  // rounding
}

TEST(Yiq, of_red_is_the_matrix_s_first_column) {
  const Yiq<double> red = yiq({1, 0, 0});
  EXPECT_EQ(red.y, 0.29889531);
  EXPECT_EQ(red.i, 0.59597799);
  EXPECT_EQ(red.q, 0.21147017);
}

}  // namespace
}  // namespace lumaknot
