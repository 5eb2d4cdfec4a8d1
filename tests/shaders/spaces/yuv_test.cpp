#include "shaders/spaces/yuv.h"

#include <gtest/gtest.h>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

Yuv<double> yuv601(const Vec3d& rgb) { return yuv_from_rgb<double>(rgb, kWeights601); }
Yuv<double> yuv709(const Vec3d& rgb) { return yuv_from_rgb<double>(rgb, kWeights709); }

/// A colour bar of 75 % and its bytes Y, C_B, C_R.
struct Bar {
  Vec3d rgb;
  int y, cb, cr;
};

/// Rec. ITU-R BT.801-1: 75 % bars, the weights of BT.601.
constexpr Bar kBars601[] = {{{0.75, 0.75, 0.75}, 180, 128, 128}, {{0.75, 0.75, 0}, 162, 44, 142},
                            {{0, 0.75, 0.75}, 131, 156, 44},     {{0, 0.75, 0}, 112, 72, 58},
                            {{0.75, 0, 0.75}, 84, 184, 198},     {{0.75, 0, 0}, 65, 100, 212},
                            {{0, 0, 0.75}, 35, 212, 114}};

/// SMPTE RP 219: the same bars with the weights of BT.709.
constexpr Bar kBars709[] = {{{0.75, 0.75, 0.75}, 180, 128, 128}, {{0.75, 0.75, 0}, 168, 44, 136},
                            {{0, 0.75, 0.75}, 145, 147, 44},     {{0, 0.75, 0}, 133, 63, 52},
                            {{0.75, 0, 0.75}, 63, 193, 204},     {{0.75, 0, 0}, 51, 109, 212},
                            {{0, 0, 0.75}, 28, 212, 120}};

/// The bytes of video range: Y from 16 to 235, C_B and C_R 112 about 128.
void expect_bytes(const Yuv<double>& yuv, const YuvWeights& w, const Bar& bar) {
  EXPECT_EQ(std::lround(16 + 219 * yuv.y), bar.y);
  EXPECT_EQ(std::lround(128 + 112 * yuv.u / w.u_max), bar.cb);
  EXPECT_EQ(std::lround(128 + 112 * yuv.v / w.v_max), bar.cr);
}

TEST(Yuv601, has_the_bytes_of_the_published_colour_bars) {
  for (const Bar& bar : kBars601) expect_bytes(yuv601(bar.rgb), kWeights601, bar);
}

TEST(Yuv709, has_the_bytes_of_the_published_colour_bars) {
  for (const Bar& bar : kBars709) expect_bytes(yuv709(bar.rgb), kWeights709, bar);
}

// The five decimals usually printed for analogue Y'UV (BT.470-6's weights), the last rounded or
// cut.
constexpr double kFiveDecimals = 1e-5;

void expect_column(const Yuv<double>& yuv, const Vec3d& column) {
  EXPECT_NEAR(yuv.y, column.x, kFiveDecimals);
  EXPECT_NEAR(yuv.u, column.y, kFiveDecimals);
  EXPECT_NEAR(yuv.v, column.z, kFiveDecimals);
}

TEST(Yuv601, is_the_published_matrix) {
  expect_column(yuv601({1, 0, 0}), {0.299, -0.14713, 0.615});
  expect_column(yuv601({0, 1, 0}), {0.587, -0.28886, -0.51499});
  expect_column(yuv601({0, 0, 1}), {0.114, 0.436, -0.10001});
}

TEST(Yuv601, comes_back_by_the_published_matrix) {
  const Vec3d from_u = rgb_from_yuv(Yuv<double>{0, 1, 0}, kWeights601);
  const Vec3d from_v = rgb_from_yuv(Yuv<double>{0, 0, 1}, kWeights601);
  EXPECT_LT(largest_magnitude(from_u - Vec3d{0, -0.39465, 2.03211}), kFiveDecimals);
  EXPECT_LT(largest_magnitude(from_v - Vec3d{1.13983, -0.58060, 0}), kFiveDecimals);
}

TEST(Yuv709, comes_back_by_the_numbers_of_bt_709) {
  // E'_CB = (E'_B - E'_Y) / 1.8556 and E'_CR = (E'_R - E'_Y) / 1.5748, exact as printed.
  const Vec3d from_u = rgb_from_yuv(Yuv<double>{0, 1, 0}, kWeights709);
  const Vec3d from_v = rgb_from_yuv(Yuv<double>{0, 0, 1}, kWeights709);
  EXPECT_NEAR(from_u.z, 1.8556, 1e-15);
  EXPECT_NEAR(from_v.x, 1.5748, 1e-15);
  EXPECT_EQ(from_u.x, 0);
  EXPECT_EQ(from_v.z, 0);
}

TEST(Yuv, chroma_reaches_its_maximum_at_full_blue_and_full_red) {
  EXPECT_NEAR(yuv601({0, 0, 1}).u, 0.436, 1e-15);
  EXPECT_NEAR(yuv601({1, 0, 0}).v, 0.615, 1e-15);
  EXPECT_NEAR(yuv709({0, 0, 1}).u, 0.5, 1e-15);
  EXPECT_NEAR(yuv709({1, 0, 0}).v, 0.5, 1e-15);
}

TEST(Yuv, the_scale_of_the_chroma_changes_no_lit_colour) {
  const YuvWeights other{kWeights601.luma, 0.5, 0.5};
  for (const Vec3d& color : color_cube(5)) {
    Yuv<double> a = yuv601(color), b = yuv_from_rgb<double>(color, other);
    a.y = b.y = a.y * 0.6 + 0.2;
    ASSERT_LT(largest_magnitude(rgb_from_yuv(a, kWeights601) - rgb_from_yuv(b, other)), 1e-15);
  }
}

}  // namespace
}  // namespace lumaknot
