#include <gtest/gtest.h>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

bool in_gamut(const Vec3d& rgb) { return largest_magnitude(rgb - saturate(rgb)) == 0; }

/// A colour produced by light, and the grey of its brightness.
struct Lit {
  Vec3d rgb;
  double neutral;
};

/// Many colours of `space` under many lights; half of them out of gamut.
std::vector<Lit> lit_colors(Space space) {
  std::vector<Lit> result;
  for (const Vec3d& color : color_cube(9)) {
    for (const double light : {0.0, 0.1, 0.5, 1.0, 1.3, 2.0, 50.0}) {
      for (const double highlight : {0.0, 0.4, -0.1}) {
        Axes<double> axes = axes_from_rgb<double>(color, space);
        axes.brightness = axes.brightness * light + highlight;
        result.push_back({rgb_from_axes(axes, space), neutral_of(axes.brightness, space)});
      }
    }
  }
  return result;
}

TEST(ReduceChroma, brings_every_colour_into_gamut) {
  for (const Space space : kLumaSpaces) {
    for (const Lit& lit : lit_colors(space)) {
      ASSERT_TRUE(in_gamut(reduce_chroma<double>(lit.rgb, lit.neutral))) << name_of(space);
      const Vec3<float> narrow = narrowed<float>(lit.rgb);
      ASSERT_TRUE(in_gamut(widened(reduce_chroma<float>(narrow, float(lit.neutral)))))
          << name_of(space);
    }
  }
}

TEST(ReduceChroma, leaves_the_colours_of_the_cube_as_they_are) {
  for (const Space space : kLumaSpaces) {
    for (const Vec3d& color : color_cube(17)) {
      const double neutral = neutral_of(brightness_of<double>(color, space), space);
      const Vec3d reduced = reduce_chroma<double>(color, neutral);
      ASSERT_LT(largest_magnitude(reduced - color), 1e-15)
          << name_of(space);  // grey + (colour - grey)
    }
  }
}

TEST(ReduceChroma, of_a_reduced_colour_is_the_colour) {
  for (const Space space : kLumaSpaces) {
    for (const Lit& lit : lit_colors(space)) {
      const Vec3d once = reduce_chroma<double>(lit.rgb, lit.neutral);
      const Vec3d twice = reduce_chroma<double>(once, lit.neutral);
      ASSERT_LT(largest_magnitude(twice - once), 1e-15) << name_of(space);  // rounding
    }
  }
}

TEST(ReduceChroma, keeps_the_hue_angle) {
  for (const Space space : kLumaSpaces) {
    for (const Lit& lit : lit_colors(space)) {
      const double g = saturate(lit.neutral);
      const Vec3d from = lit.rgb - grey(g);
      const Vec3d to = reduce_chroma<double>(lit.rgb, lit.neutral) - grey(g);
      if (g < 1e-6 || g > 1 - 1e-6) {
        // Black or white, without hue. The guard of 1 / 0, for the channel that is farthest out; a
        // channel of lesser weight in the brightness (blue: 0.0722) is up to 13 times as far.
        ASSERT_LT(largest_magnitude(to), 1.3e-5) << name_of(space);
        continue;
      }
      const double scale = 1 + largest_magnitude(from);
      ASSERT_LT(largest_magnitude(cross(from, to)), 1e-15 * scale) << name_of(space);  // rounding
      ASSERT_GE(dot(from, to), 0) << name_of(space);
    }
  }
}

TEST(ReduceChroma, keeps_as_much_chroma_as_fits) {
  for (const Space space : kLumaSpaces) {
    for (const Lit& lit : lit_colors(space)) {
      const double g = saturate(lit.neutral);
      if (in_gamut(lit.rgb) || g < 1e-3 || g > 1 - 1e-3) continue;
      const Vec3d reduced = reduce_chroma<double>(lit.rgb, lit.neutral);
      const auto [min, max] = std::minmax({reduced.x, reduced.y, reduced.z});
      ASSERT_TRUE(min < 1e-12 || max > 1 - 1e-12) << name_of(space);  // touches the cube
    }
  }
}

TEST(ReduceChroma, makes_white_of_brightness_beyond_white_and_black_of_none) {
  for (const Vec3d& color : {Vec3d{3, 1.2, 0.4}, Vec3d{1.2, 1.2, 1.2}}) {
    EXPECT_LT(largest_magnitude(reduce_chroma(color, 1.4) - grey(1.0)),
              1.3e-5);  // the guard of 1 / 0
  }
  EXPECT_LT(largest_magnitude(reduce_chroma(Vec3d{0.3, -0.2, -0.4}, -0.1)), 1.3e-5);
}

TEST(ReduceChroma, keeps_the_luma_of_the_linear_spaces) {
  for (const Space space : {Space::kYiq, Space::kYuv601, Space::kYuv709}) {
    for (const Lit& lit : lit_colors(space)) {
      const Vec3d reduced = reduce_chroma<double>(lit.rgb, lit.neutral);
      // 5e-6: the guard of 1 / 0 near black and white; 1e-8 YIQ's printed digits, times chroma.
      ASSERT_NEAR(brightness_of<double>(reduced, space), saturate(lit.neutral), 5e-6)
          << name_of(space);
    }
  }
}

/// The largest change of brightness by reduce_chroma and by clamping.
struct Shift {
  double reduced = 0, clamped = 0;
};

Shift brightness_shift(Space space) {
  Shift shift;
  for (const Vec3d& color : color_cube(17)) {
    for (const double light : {0.1, 0.3, 0.5, 0.8, 1.2, 1.6}) {
      const double brightness = brightness_of<double>(color, space) * light;
      if (brightness > 1) continue;
      const Vec3d lit = with_light(color, light, 0.0, space);
      const double neutral = neutral_of(brightness, space);
      const auto change = [&](const Vec3d& rgb) {
        return std::abs(brightness_of<double>(rgb, space) - brightness);
      };
      shift.reduced = std::max(shift.reduced, change(reduce_chroma<double>(lit, neutral)));
      shift.clamped = std::max(shift.clamped, change(saturate(lit)));
    }
  }
  return shift;
}

/// The part of the cube's colours that `light` puts out of gamut.
double share_out_of_gamut(Space space, double light) {
  const std::vector<Vec3d> colors = color_cube(17);
  const auto out = std::ranges::count_if(colors, [&](const Vec3d& color) {
    const Vec3d lit = with_light(color, light, 0.0, space);
    return largest_magnitude(lit - saturate(lit)) > 1e-6;  // YIQ's printed digits
  });
  return double(out) / double(colors.size());
}

/// The figures of docs/spaces.
struct Documented {
  Space space;
  double out_at_half, out_at_1_2;  ///< share of the cube's colours
  double reduced, clamped;         ///< largest shift of brightness
};
constexpr Documented kDocumented[] = {
    {Space::kYiq, 0.57, 0.36, 0, 0.220},        {Space::kYuv601, 0.57, 0.36, 0, 0.220},
    {Space::kYuv709, 0.55, 0.36, 0, 0.183},     {Space::kCielab, 0.72, 0.41, 0.069, 0.186},
    {Space::kCieluv, 0.83, 0.39, 0.060, 0.160}, {Space::kDin99, 0.77, 0.51, 0.085, 0.240},
    {Space::kAtd95, 0.84, 0.38, 0.061, 0.220}};

TEST(ReduceChroma, shifts_the_brightness_by_the_documented_part_of_what_clamping_does) {
  for (const Documented& documented : kDocumented) {
    const Shift shift = brightness_shift(documented.space);
    EXPECT_NEAR(shift.reduced, documented.reduced, 5e-4) << name_of(documented.space);
    EXPECT_NEAR(shift.clamped, documented.clamped, 5e-4) << name_of(documented.space);
  }
}

TEST(OutOfGamut, is_the_documented_share_of_the_cube) {
  for (const Documented& documented : kDocumented) {
    const Space space = documented.space;
    EXPECT_NEAR(share_out_of_gamut(space, 0.5), documented.out_at_half, 5e-3) << name_of(space);
    EXPECT_NEAR(share_out_of_gamut(space, 1.2), documented.out_at_1_2, 5e-3) << name_of(space);
  }
}

TEST(ReduceChroma, of_numbers_far_beyond_the_cube_is_in_gamut) {
  for (const double huge : {1e6, 1e20, 1e30}) {
    const Vec3<float> color{float(huge), float(-huge), float(huge / 3)};
    for (const float neutral : {-1e30f, -0.1f, 0.0f, 1e-20f, 0.5f, 1.0f, 1e30f}) {
      EXPECT_TRUE(in_gamut(widened(reduce_chroma<float>(color, neutral)))) << huge << neutral;
    }
  }
}

}  // namespace
}  // namespace lumaknot
