#include "shaders/spaces/conversions.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// The largest round-trip error of a channel. YIQ: its matrices are inverse up to their eight
/// printed decimals. The others: the roundings of one conversion, 40 to 100 of 1.1e-16 (double) or
/// 6e-8 (float), which the steep start of the sRGB curve multiplies by up to 12.92. Measured: half
/// of these. In float they are below the bounds derived in error_test.cpp.
struct RoundTrip {
  double in_double, in_float;
};
const std::map<Space, RoundTrip> kRoundTrip{
    {Space::kYiq, {3e-8, 5e-7}},     {Space::kYuv601, {1e-15, 5e-7}},
    {Space::kYuv709, {1e-15, 5e-7}}, {Space::kCielab, {2e-14, 1.3e-5}},
    {Space::kCieluv, {4e-14, 2e-5}}, {Space::kDin99, {3e-14, 2.2e-5}},
    {Space::kAtd95, {1e-13, 5e-5}}};

template <class S>
double round_trip_error(Space space) {
  double error = 0;
  for (const Vec3d& color : color_cube(33)) {
    const Vec3<S> back = rgb_from_axes(axes_from_rgb<S>(narrowed<S>(color), space), space);
    error = std::max(error, largest_magnitude(widened(back) - widened(narrowed<S>(color))));
  }
  return error;
}

TEST(ColorSpace, every_colour_of_the_cube_survives_the_round_trip_in_double) {
  for (const Space space : kLumaSpaces) {
    const double error = round_trip_error<double>(space);
    EXPECT_LT(error, kRoundTrip.at(space).in_double) << name_of(space);
  }
}

TEST(ColorSpace, every_colour_of_the_cube_survives_the_round_trip_in_float) {
  for (const Space space : kLumaSpaces) {
    EXPECT_LT(round_trip_error<float>(space), kRoundTrip.at(space).in_float) << name_of(space);
  }
}

TEST(ColorSpace, every_shade_of_grey_survives_the_round_trip_where_the_curves_change_pieces) {
  for (const Space space : kLumaSpaces) {
    for (int i = 0; i <= 4096; ++i) {
      const double shade = i / 4096.0;
      const Vec3d back = rgb_from_axes(axes_from_rgb<double>(grey(shade), space), space);
      ASSERT_LT(largest_magnitude(back - grey(shade)), kRoundTrip.at(space).in_double)
          << name_of(space) << " " << shade;
    }
  }
}

TEST(ColorSpace, brightness_is_0_for_black_and_1_for_white) {
  for (const Space space : kLumaSpaces) {
    // YIQ's weights add up to 1 + 1e-8 as the paper prints them.
    const double tolerance = space == Space::kYiq ? 2e-8 : 1e-15;
    EXPECT_NEAR(brightness_of<double>(grey(0.0), space), 0, tolerance) << name_of(space);
    EXPECT_NEAR(brightness_of<double>(grey(1.0), space), 1, tolerance) << name_of(space);
    EXPECT_NEAR(brightness_of<float>(grey(0.0f), space), 0, 1e-7) << name_of(space);
    EXPECT_NEAR(brightness_of<float>(grey(1.0f), space), 1, 1e-6) << name_of(space);
  }
}

TEST(ColorSpace, brightness_of_is_the_brightness_of_the_axes) {
  for (const Space space : kLumaSpaces) {
    for (const Vec3d& color : color_cube(9)) {
      ASSERT_EQ(brightness_of<double>(color, space), axes_from_rgb<double>(color, space).brightness)
          << name_of(space);
    }
  }
}

TEST(ColorSpace, no_colour_is_darker_than_black_or_brighter_than_white) {
  for (const Space space : kLumaSpaces) {
    for (const Vec3d& color : color_cube(33)) {
      const double brightness = brightness_of<double>(color, space);
      ASSERT_GE(brightness, -1e-15) << name_of(space);    // rounding of L* = 116 f - 16
      ASSERT_LE(brightness, 1 + 2e-8) << name_of(space);  // YIQ's printed weights
    }
  }
}

TEST(ColorSpace, greys_have_no_chroma) {
  for (const Space space : kLumaSpaces) {
    // Axes reach 0.5 in the linear spaces, 180 in the others; 1e-8: YIQ's printed digits.
    const double tolerance = is_linear(space) ? 2e-8 : 1e-12;
    for (const double shade : {0.0, 0.01, 0.2, 0.5, 0.9, 1.0}) {
      const Axes<double> axes = axes_from_rgb<double>(grey(shade), space);
      EXPECT_NEAR(axes.c1, 0, tolerance) << name_of(space) << " " << shade;
      EXPECT_NEAR(axes.c2, 0, tolerance) << name_of(space) << " " << shade;
    }
  }
}

TEST(ColorSpace, light_leaves_grey_grey_and_neutral_of_says_which) {
  for (const Space space : kLumaSpaces) {
    for (const double brightness : {-0.2, 0.0, 0.001, 0.08, 0.3, 0.7, 1.0, 1.5, 4.0}) {
      const Vec3d rgb = rgb_from_axes(Axes<double>{brightness, 0, 0}, space);
      const Vec3d expected = grey(neutral_of(brightness, space));
      EXPECT_LT(largest_magnitude(rgb - expected), 1e-14) << name_of(space) << " " << brightness;
    }
  }
}

TEST(ColorSpace, neutral_of_gives_back_the_shade_of_a_grey) {
  for (const Space space : kLumaSpaces) {
    const double tolerance = space == Space::kYiq ? 2e-8 : 1e-13;  // printed digits; rounding
    for (const double shade : {0.0, 0.02, 0.3, 0.6, 1.0}) {
      const double brightness = brightness_of<double>(grey(shade), space);
      EXPECT_NEAR(neutral_of(brightness, space), shade, tolerance) << name_of(space);
    }
  }
}

TEST(ColorSpace, light_changes_the_brightness_and_leaves_the_chroma) {
  for (const Space space : kLumaSpaces) {
    const double tolerance = space == Space::kYiq ? 1e-7 : 1e-11;  // axes reach 180
    for (const Vec3d& color : color_cube(9)) {
      const Axes<double> before = axes_from_rgb<double>(color, space);
      const Vec3d lit = with_light(color, 0.9, 0.02, space);
      if (largest_magnitude(lit - saturate(lit)) > 0) continue;  // not a colour of the cube
      const Axes<double> after = axes_from_rgb<double>(lit, space);
      ASSERT_NEAR(after.brightness, before.brightness * 0.9 + 0.02, tolerance) << name_of(space);
      ASSERT_NEAR(after.c1, before.c1, tolerance) << name_of(space);
      ASSERT_NEAR(after.c2, before.c2, tolerance) << name_of(space);
    }
  }
}

TEST(ColorSpace, more_light_never_makes_a_grey_darker) {
  for (const Space space : kLumaSpaces) {
    for (int hundredths = -20; hundredths < 300; ++hundredths) {
      const double brightness = hundredths / 100.0;
      ASSERT_LT(neutral_of(brightness, space), neutral_of(brightness + 0.01, space))
          << name_of(space) << " " << brightness;
    }
  }
}

template <class S>
void expect_finite_axes(const Vec3d& rgb, Space space) {
  const Axes<S> axes = axes_from_rgb<S>(narrowed<S>(rgb), space);
  ASSERT_TRUE(std::isfinite(axes.brightness) && std::isfinite(axes.c1) && std::isfinite(axes.c2))
      << name_of(space) << " " << rgb.x << " " << rgb.y << " " << rgb.z;
}

TEST(ColorSpace, axes_are_finite_beyond_the_cube) {
  for (const Space space : kLumaSpaces) {
    for (const Vec3d& color : color_cube(17)) {
      expect_finite_axes<double>(color * 4.0 - grey(2.0), space);
      expect_finite_axes<float>(color * 4.0 - grey(2.0), space);
    }
  }
}

/// `chroma` with every brightness that a light can produce.
template <class S>
void expect_finite_colors(Axes<S> axes, Space space) {
  for (const double brightness :
       {-1.0, -0.2, -0.1, -1e-3, -1e-8, 0.0, 1e-30, 1e-8, 1e-3, 0.1, 0.5, 1.0, 3.0, 50.0, 1000.0}) {
    axes.brightness = S(brightness);
    ASSERT_TRUE(is_finite(widened(rgb_from_axes(axes, space))))
        << name_of(space) << " " << brightness << " " << axes.c1 << " " << axes.c2;
    ASSERT_TRUE(std::isfinite(neutral_of(axes.brightness, space))) << name_of(space);
  }
}

TEST(ColorSpace, any_chroma_of_the_cube_with_any_brightness_of_a_light_is_finite) {
  for (const Space space : kLumaSpaces) {
    for (const Vec3d& color : color_cube(17)) {
      expect_finite_colors(axes_from_rgb<double>(color, space), space);
      expect_finite_colors(axes_from_rgb<float>(narrowed<float>(color), space), space);
    }
  }
}

TEST(ColorSpace, linear_spaces_are_those_where_light_moves_every_channel_alike) {
  const Vec3d color{0.7, 0.4, 0.2};
  for (const Space space : kLumaSpaces) {
    const Axes<double> axes = axes_from_rgb<double>(color, space);
    const Vec3d moved = rgb_from_axes(Axes<double>{axes.brightness + 0.1, axes.c1, axes.c2}, space);
    const double unequal = largest_magnitude((moved - color) - grey(0.1));
    EXPECT_EQ(unequal < 1e-7, is_linear(space)) << name_of(space);  // YIQ's printed digits
  }
}

}  // namespace
}  // namespace lumaknot
