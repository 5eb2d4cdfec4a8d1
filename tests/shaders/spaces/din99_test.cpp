#include "shaders/spaces/din99.h"

#include <gtest/gtest.h>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

Vec3d din99(const Lab<double>& lab) {
  const Din99<double> c = din99_from_lab(lab);
  return {c.lightness, c.a, c.b};
}

Vec3d lab_of(const Vec3d& c) {
  const Lab<double> lab = lab_from_din99(Din99<double>{c.x, c.y, c.z});
  return {lab.lightness, lab.a, lab.b};
}

TEST(Din99, has_the_published_sample_values) {
  // The table of the article "DIN99-Farbraum" of the German Wikipedia, two decimals.
  constexpr double kTwoDecimals = 5e-3;
  const std::pair<Lab<double>, Vec3d> samples[] = {{{50, 10, 10}, {61.43, 9.70, 3.76}},
                                                   {{50, 50, 50}, {61.43, 28.64, 11.11}},
                                                   {{50, -10, 10}, {61.43, -5.57, 7.03}},
                                                   {{50, -50, 50}, {61.43, -17.22, 21.75}},
                                                   {{50, -10, -10}, {61.43, -9.70, -3.76}},
                                                   {{50, -50, -50}, {61.43, -28.64, -11.11}},
                                                   {{50, 10, -10}, {61.43, 5.57, -7.03}},
                                                   {{50, 50, -50}, {61.43, 17.22, -21.75}},
                                                   {{0, 0, 0}, {0, 0, 0}},
                                                   {{100, 0, 0}, {100, 0, 0}}};
  for (const auto& [lab, expected] : samples) {
    EXPECT_LT(largest_magnitude(din99(lab) - expected), kTwoDecimals);
    const Vec3d back = lab_of(expected) - Vec3d{lab.lightness, lab.a, lab.b};
    // Two decimals grow by d chroma / d chroma99 = 1 + 0.045 G, up to 4, and 1 / 0.7.
    EXPECT_LT(largest_magnitude(back), kTwoDecimals * 4 / 0.7);
  }
}

TEST(Din99, of_the_colour_library_s_manual) {
  // colour-science 0.4.7, manual and tests of Lab_to_DIN99, eight decimals. It has ASTM D2244-07's
  // 105.509 where DIN 6176 has 105.51.
  const std::pair<Lab<double>, Vec3d> samples[] = {
      {{41.52787529, 52.63858304, 26.92317922}, {53.22821988, 28.41634656, 3.89839552}},
      {{55.11636304, -41.08791787, 30.91825778}, {66.08943912, -17.35290106, 16.09690691}},
      {{29.80565520, 20.01830466, -48.34913874}, {40.71533366, 3.48714163, -21.45321411}}};
  for (const auto& [lab, astm] : samples) {
    const Vec3d expected{astm.x * 105.51 / 105.509, astm.y, astm.z};
    EXPECT_LT(largest_magnitude(din99(lab) - expected), 5.1e-9);
    EXPECT_LT(largest_magnitude(lab_of(expected) - Vec3d{lab.lightness, lab.a, lab.b}),
              5e-8);  // as above
  }
}

TEST(Din99, white_is_that_of_the_formula) {
  EXPECT_NEAR(din99({100, 0, 0}).x, kDin99White, 1e-13);
  EXPECT_NEAR(kDin99White, 100.0013, 5e-5);
}

TEST(Din99, brighter_than_white_goes_on_along_the_tangent) {
  const double step = 1e-4;
  const double below = lightness_of_din99(kDin99White) - lightness_of_din99(kDin99White - step);
  const double above = lightness_of_din99(kDin99White + step) - lightness_of_din99(kDin99White);
  EXPECT_NEAR(below / above, 1, 1e-6);  // curvature 1 / 105.5 times the step
  EXPECT_NEAR(lightness_of_din99(kDin99White), 100, 1e-12);
  const double slope = 2.58 / (105.51 * 0.0158);
  EXPECT_NEAR(lightness_of_din99(50 * kDin99White), 100 + slope * 49 * kDin99White, 1e-9);
}

TEST(Din99, light_leaves_a_and_b_of_cielab_alone) {
  // a99 and b99 depend only on a* and b*, so keeping the latter keeps the former: lit in DIN99 is
  // lit in CIELAB with L99 as the brightness.
  for (const Vec3d& color : color_cube(9)) {
    Lab<double> lab = lab_from_xyz<double>(xyz_from_rgb<double>(color));
    const double lit = 0.6 * din99_lightness(lab.lightness) + 0.1 * kDin99White;
    lab.lightness = lightness_of_din99(lit);
    const Vec3d expected = rgb_from_xyz<double>(xyz_from_lab(lab));
    ASSERT_LT(largest_magnitude(with_light(color, 0.6, 0.1, Space::kDin99) - expected), 1e-13);
  }
}

}  // namespace
}  // namespace lumaknot
