#include <gtest/gtest.h>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

Lab<double> lab(const Vec3d& rgb) { return lab_from_xyz<double>(xyz_from_rgb<double>(rgb)); }
Luv<double> luv(const Vec3d& rgb) { return luv_from_xyz<double>(xyz_from_rgb<double>(rgb)); }
Vec3d as_vec(const Lab<double>& c) { return {c.lightness, c.a, c.b}; }
Vec3d as_vec(const Luv<double>& c) { return {c.lightness, c.u, c.v}; }

TEST(Srgb, curve_has_the_published_values) {
  // IEC 61966-2-1: linear below 0.04045, there 1 / 12.92; 8-bit greys as commonly tabulated.
  EXPECT_NEAR(decode_srgb(0.04), 0.04 / 12.92, 1e-17);
  EXPECT_NEAR(decode_srgb(128 / 255.0), 0.215861, 5e-7);
  EXPECT_NEAR(decode_srgb(0.5), 0.214041, 5e-7);
  EXPECT_NEAR(encode_srgb(0.18), 0.461356, 5e-7);
  EXPECT_EQ(decode_srgb(0.0), 0);
  EXPECT_NEAR(decode_srgb(1.0), 1, 1e-15);
}

TEST(Srgb, curve_and_its_inverse_are_odd) {
  for (const double x : {0.001, 0.02, 0.3, 1.0, 1.7}) {
    EXPECT_EQ(decode_srgb(-x), -decode_srgb(x));
    EXPECT_EQ(encode_srgb(-x), -encode_srgb(x));
    EXPECT_NEAR(encode_srgb(decode_srgb(x)), x, 1e-15);
  }
}

TEST(Srgb, pieces_of_the_curve_meet_within_the_standard_s_rounding) {
  EXPECT_NEAR(decode_srgb(std::nextafter(0.04045, 1.0)), decode_srgb(0.04045), 2.4e-9);
  EXPECT_NEAR(encode_srgb(std::nextafter(0.0031308, 1.0)), encode_srgb(0.0031308), 2.9e-8);
}

TEST(Srgb, matrix_is_the_standard_s_in_four_digits) {
  const Vec3d printed[] = {
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(largest_magnitude(kXyzFromLinear.rows[i] - printed[i]), 5e-5);  // half a last digit
  }
}

TEST(Srgb, primaries_and_white_have_the_chromaticities_of_bt_709) {
  const auto expect_chromaticity = [](const Vec3d& rgb, double x, double y) {
    const Vec3d xyz = xyz_from_rgb<double>(rgb);
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), x, 1e-15);
    EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), y, 1e-15);
  };
  expect_chromaticity({1, 0, 0}, 0.64, 0.33);
  expect_chromaticity({0, 1, 0}, 0.30, 0.60);
  expect_chromaticity({0, 0, 1}, 0.15, 0.06);
  expect_chromaticity({1, 1, 1}, 0.3127, 0.3290);
}

/// A row of HSLuv's reference table (hsluv/hsluv on GitHub, snapshot-rev4.json).
struct Row {
  Vec3d rgb, xyz, luv;
};
const Row kHsluv[] = {{{4 / 15.0, 1 / 15.0, 0.6},
                       {0.08333440147821408, 0.039297119195212456, 0.30457451431554816},
                       {23.43769832774617, 3.7406310226982495, -74.76936719784993}},
                      {{4 / 15.0, 1 / 15.0, 1},
                       {0.20632361622116469, 0.08849280509239338, 0.9523177119617697},
                       {35.69247302990261, -4.57713081064657, -133.1348845050823}},
                      {{4 / 15.0, 2 / 15.0, 0},
                       {0.029558451554102638, 0.023731737201196354, 0.0030241009570323328},
                       {17.335054234495246, 22.939934036980937, 16.43787544481942}},
                      {{4 / 15.0, 2 / 15.0, 8 / 15.0},
                       {0.07399306110390931, 0.04150558102111927, 0.2370463779193529},
                       {24.16306256867677, 3.901360261081485, -63.75403795120868}},
                      {{4 / 15.0, 0.2, 0.2},
                       {0.04165094801368533, 0.03835709112744694, 0.036530486671715184},
                       {23.120693409411984, 9.456709543870385, 2.040648444186429}},
                      {{4 / 15.0, 4 / 15.0, 0},
                       {0.04450874412607948, 0.05363232234515046, 0.008007531814357809},
                       {27.74551397494701, 2.2005424241160507, 30.507410892539095}}};

TEST(Srgb, xyz_is_that_of_the_hsluv_table) {
  for (const Row& row : kHsluv) {
    // Its matrix has 14 digits.
    EXPECT_LT(largest_magnitude(xyz_from_rgb<double>(row.rgb) - row.xyz), 1e-13);
    EXPECT_LT(largest_magnitude(rgb_from_xyz<double>(row.xyz) - row.rgb), 1e-12);
  }
}

TEST(Cieluv, is_that_of_the_hsluv_table) {
  for (const Row& row : kHsluv) {
    // Numbers up to 133 with 14 digits in its white.
    EXPECT_LT(largest_magnitude(as_vec(luv(row.rgb)) - row.luv), 1e-11);
    const Luv<double> printed{row.luv.x, row.luv.y, row.luv.z};
    EXPECT_LT(largest_magnitude(xyz_from_luv(printed) - row.xyz), 1e-13);
  }
}

TEST(Cieluv, has_the_u_and_v_of_the_primaries_chromaticities) {
  // CIE 15:2004: u' = 4 x / (-2 x + 12 y + 3), v' = 9 y / (-2 x + 12 y + 3).
  const auto expect_uv = [](const Vec3d& rgb, double x, double y) {
    const Luv<double> c = luv(rgb);
    const double part = -2 * x + 12 * y + 3;
    EXPECT_NEAR(c.u / (13 * c.lightness) + kWhiteU, 4 * x / part, 1e-14);
    EXPECT_NEAR(c.v / (13 * c.lightness) + kWhiteV, 9 * y / part, 1e-14);
  };
  expect_uv({1, 0, 0}, 0.64, 0.33);
  expect_uv({0, 1, 0}, 0.30, 0.60);
  expect_uv({0, 0, 1}, 0.15, 0.06);
  expect_uv({1, 1, 1}, 0.3127, 0.3290);
}

TEST(Cielab, is_that_of_lindbloom_s_calculator) {
  // B. Lindbloom, CIE Color Calculator: sRGB, D65. His white is 0.95047, 1, 1.08883, in which the
  // primaries' X and Z differ by up to 2e-4: 0.01 in a* and b*.
  constexpr double kOtherWhite = 0.01;
  EXPECT_LT(largest_magnitude(as_vec(lab({1, 0, 0})) - Vec3d{53.2408, 80.0925, 67.2032}),
            kOtherWhite);
  EXPECT_LT(largest_magnitude(as_vec(lab({0, 1, 0})) - Vec3d{87.7347, -86.1827, 83.1793}),
            kOtherWhite);
  EXPECT_LT(largest_magnitude(as_vec(lab({0, 0, 1})) - Vec3d{32.2970, 79.1875, -107.8602}),
            kOtherWhite);
  EXPECT_LT(largest_magnitude(as_vec(lab(grey(128 / 255.0))) - Vec3d{53.5850, 0, 0}), 5e-5);
}

TEST(Cielab, and_cieluv_are_those_of_the_colour_library_s_manual) {
  // colour-science 0.4.7, manual of XYZ_to_Lab and XYZ_to_Luv, white 0.3127, 0.3290; 8 decimals.
  const Vec3d xyz{0.20654008, 0.12197225, 0.05136952};
  const Vec3d expected_lab{41.52787529, 52.63858304, 26.92317922};
  const Vec3d expected_luv{41.52787529, 96.83626054, 17.75210149};
  EXPECT_LT(largest_magnitude(as_vec(lab_from_xyz<double>(xyz)) - expected_lab), 5.1e-9);
  EXPECT_LT(largest_magnitude(as_vec(luv_from_xyz<double>(xyz)) - expected_luv), 5.1e-9);
  // Back: the last printed digit of L*, a*, b*.
  EXPECT_LT(
      largest_magnitude(xyz_from_lab(Lab<double>{41.52787529, 52.63858304, 26.92317922}) - xyz),
      1e-9);
  EXPECT_LT(
      largest_magnitude(xyz_from_luv(Luv<double>{41.52787529, 96.83626054, 17.75210149}) - xyz),
      1e-9);
}

TEST(Cielab, of_more_colours_is_that_of_the_colour_library) {
  // Computed with colour-science 0.4.7, nine digits.
  EXPECT_LT(
      largest_magnitude(as_vec(lab({0.8, 0.5, 0.2})) - Vec3d{60.2361143, 23.3600773, 51.8443632}),
      5.1e-8);
  EXPECT_LT(
      largest_magnitude(as_vec(lab({0.1, 0.3, 0.6})) - Vec3d{33.4580035, 12.8565018, -46.532328}),
      5.1e-8);
  EXPECT_LT(largest_magnitude(as_vec(lab({0.02, 0.01, 0.03})) -
                              Vec3d{0.948757295, 1.3761147, -1.6952248}),
            5.1e-8);
}

TEST(Cielab, curve_is_smooth_where_its_pieces_meet) {
  const double meet = 216.0 / 24389, step = 1e-7;
  EXPECT_NEAR(lab_curve(meet), 6.0 / 29, 1e-15);
  const double below = (lab_curve(meet) - lab_curve(meet - step)) / step;
  const double above = (lab_curve(meet + step) - lab_curve(meet)) / step;
  EXPECT_NEAR(below, above, 1e-4);  // second derivative 590 times the step
  for (const double t : {-0.1, 0.0, 0.004, 0.01, 0.5, 3.0}) {
    EXPECT_NEAR(inverse_lab_curve(lab_curve(t)), t, 1e-15);
  }
}

TEST(Cieluv, u_and_v_stay_as_long_as_they_are_a_colour) {
  const Luv<double> orange = luv({0.9, 0.5, 0.1});
  for (const double lightness : {90.0, 60.0, 40.0}) {
    const Luv<double> lit{lightness, orange.u, orange.v};
    const Luv<double> back = luv_from_xyz<double>(xyz_from_luv(lit));
    EXPECT_NEAR(back.lightness, lightness, 1e-12);
    EXPECT_NEAR(back.u, lit.u, 1e-11);
    EXPECT_NEAR(back.v, lit.v, 1e-11);
  }
}

TEST(Cieluv, in_the_dark_keeps_its_hue_and_the_saturation_of_the_radius) {
  const Luv<double> blue = luv({0, 0, 1});
  for (const double lightness : {20.0, 5.0, 0.1}) {
    const Vec3d xyz = xyz_from_luv(Luv<double>{lightness, blue.u, blue.v});
    const double part = dot(kUvDenominator, xyz);
    const double u = 4 * xyz.x / part - kWhiteU, v = 9 * xyz.y / part - kWhiteV;
    EXPECT_NEAR(std::hypot(u, v), kUvRadius, 1e-12);
    EXPECT_NEAR(u * blue.v - v * blue.u, 0, 1e-12);
    EXPECT_GT(v * blue.v, 0);
  }
}

TEST(Cieluv, of_no_lightness_is_black_whatever_the_chroma) {
  for (const Vec3d& color : color_cube(5)) {
    const Luv<double> c = luv(color);
    EXPECT_LT(largest_magnitude(xyz_from_luv(Luv<double>{0, c.u, c.v})), 1e-15);  // L* to Y rounds
    // Y is L* / 903.3; Z at most 12 / (4 v') of that, v' at least 0.148.
    EXPECT_LT(largest_magnitude(xyz_from_luv(Luv<double>{1e-6, c.u, c.v})), 21 * 1e-6 / 903.3);
  }
}

TEST(Cieluv, circle_holds_every_colour_of_the_cube) {
  for (const Vec3d& color : color_cube(33)) {
    const Luv<double> c = luv(color);
    ASSERT_LE(std::hypot(c.u, c.v), 0.3113 * 13 * c.lightness + 1e-12);
  }
}

}  // namespace
}  // namespace lumaknot
