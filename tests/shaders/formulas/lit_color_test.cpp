#include <gtest/gtest.h>

#include "scene/presets.h"
#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;      // a few operations on numbers near one
constexpr double kPrintedDigits = 1e-6;  // how far M and W are from inverse, times a light of 2

/// The weights of a formula by name.
struct Weights {
  double ambient = 0, diffuse = 1, specular = 1, luma_offset = 0;
};

/// The colour that `texture` becomes where the light sends grey terms L_D and L_S.
Vec3d lit(const char* formula, const Vec3d& texture, double diffuse, double specular,
          const Weights& weights = {}) {
  View view;
  view.ambient = weights.ambient;
  Material m = *with_formula(Material{}, formula);
  m.diffuse = weights.diffuse;
  m.specular = weights.specular;
  m.luma_offset = weights.luma_offset;
  const Terms<double> terms{grey(diffuse), grey(specular)};
  return lit_color(texture, terms, lighting_of<double>(view, m), m);
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Luma and chroma by the digits that the paper prints.
double luma(const Vec3d& c) { return 0.29889531 * c.x + 0.58662247 * c.y + 0.11448223 * c.z; }
double chroma_i(const Vec3d& c) { return 0.59597799 * c.x - 0.27417610 * c.y - 0.32180189 * c.z; }
double chroma_q(const Vec3d& c) { return 0.21147017 * c.x - 0.52261711 * c.y + 0.31114694 * c.z; }

TEST(LitColor, equation_3_scales_by_the_light_and_adds_the_highlight) {
  expect_near(lit("phong", {0.2, 0.4, 0.6}, 0.5, 0.25, {.ambient = 0.1}), {0.37, 0.49, 0.61},
              kRounding);
}

TEST(LitColor, weights_scale_their_terms_and_spare_the_ambient_light) {
  // Light 0.1 + 0.4, highlight 0.2.
  expect_near(
      lit("phong", {0.2, 0.4, 0.6}, 0.8, 0.1, {.ambient = 0.1, .diffuse = 0.5, .specular = 2}),
      {0.3, 0.4, 0.5}, kRounding);
}

TEST(LitColor, equations_6_to_8_change_luma_and_keep_chroma) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d t = random.texture();
    const double diffuse = random.number(0, 1), specular = random.number(0, 1);
    const Vec3d f = lit("yiq-eq6", t, diffuse, specular, {.ambient = 0.1});
    ASSERT_NEAR(luma(f), luma(t) * (0.1 + diffuse) + specular, kPrintedDigits);
    ASSERT_NEAR(chroma_i(f), chroma_i(t), kPrintedDigits);
    ASSERT_NEAR(chroma_q(f), chroma_q(t), kPrintedDigits);
  }
}

TEST(LitColor, yiq_collapses_to_the_texture_plus_a_difference_of_luma) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d t = random.texture();
    const double diffuse = random.number(0, 1), specular = random.number(0, 1);
    const double change = luma(t) * (0.1 + diffuse) + specular - luma(t);
    const Vec3d expected = t + Vec3d{change, change, change};
    expect_near(lit("yiq-eq6", t, diffuse, specular, {.ambient = 0.1}), expected, kPrintedDigits);
    expect_near(lit("yiq-collapsed-phong", t, diffuse, specular, {.ambient = 0.1}), expected,
                kRounding);
  }
}

TEST(LitColor, full_light_leaves_the_texture_in_both_spaces) {
  const Vec3d t{0.9, 0.3, 0.1};
  expect_near(lit("phong", t, 1, 0), t, kRounding);
  expect_near(lit("yiq-eq6", t, 1, 0), t, kPrintedDigits);
}

TEST(LitColor, spaces_agree_on_a_grey_texture) {
  // No chroma to keep: the two models are one.
  for (const double shade : {0.0, 0.3, 1.0}) {
    expect_near(lit("phong", grey(shade), 0.6, 0.2, {.ambient = 0.1}),
                lit("yiq-eq6", grey(shade), 0.6, 0.2, {.ambient = 0.1}), kPrintedDigits);
  }
}

TEST(LitColor, phong_s_highlight_alone_is_exactly_grey_whatever_the_texture) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const double highlight = random.number(0, 1);
    const Vec3d t = random.texture();
    ASSERT_EQ(lit("phong", t, random.number(0, 1), highlight, {.diffuse = 0}), grey(highlight));
  }
}

TEST(LitColor, yiq_s_highlight_alone_keeps_the_surface_s_chroma) {
  const Vec3d copper{0.72, 0.45, 0.2};
  const Vec3d f = lit("yiq-eq6", copper, 0.9, 0.5, {.diffuse = 0});
  EXPECT_NEAR(luma(f), 0.5, kPrintedDigits);
  EXPECT_NEAR(f.x - f.z, copper.x - copper.z, kPrintedDigits);
}

TEST(LitColor, without_clamps_nothing_is_limited) {
  expect_near(lit("phong", {1, 1, 1}, 1, 1, {.ambient = 0.5}), {2.5, 2.5, 2.5}, kRounding);
  EXPECT_LT(lit("yiq-eq6", {1, 0, 0}, 0, 0).y, 0);  // chroma without luma is no colour of the cube
}

Vec3d clamped_rgb(const Vec3d& texture, double diffuse, const Weights& weights) {
  View view;
  view.ambient = weights.ambient;
  Material m;
  m.clamp = Clamp::kTable1;
  m.diffuse = weights.diffuse;
  return lit_color<double>(texture, {grey(diffuse), {}}, lighting_of<double>(view, m), m);
}

TEST(LitColor, table_1_clamps_the_sum_of_diffuse_and_ambient_light) {
  expect_near(clamped_rgb({0.2, 0.4, 0.6}, 0.8, {.ambient = 0.5}), {0.2, 0.4, 0.6}, kRounding);
}

TEST(LitColor, table_1_clamps_the_diffuse_term_before_its_weight) {
  expect_near(clamped_rgb({1, 1, 1}, 1.5, {.diffuse = 0.5}), {0.5, 0.5, 0.5}, kRounding);
}

TEST(LitColor, table_1_clamps_the_colour) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d t = random.texture();
    const double diffuse = random.number(0, 1), specular = random.number(0, 1);
    const Vec3d f = lit("yiq-table1", t, diffuse, specular, {.ambient = 0.1, .luma_offset = -0.1});
    for (const double c : components(f)) {
      ASSERT_GE(c, 0);
      ASSERT_LE(c, 1);
    }
  }
}

TEST(LitColor, luma_offset_shifts_every_channel_of_yiq_alike) {
  const Vec3d t{0.5, 0.6, 0.7};
  expect_near(lit("yiq-eq6", t, 0.5, 0.1) - lit("yiq-eq6", t, 0.5, 0.1, {.luma_offset = -0.1}),
              {0.1, 0.1, 0.1}, kRounding);
}

}  // namespace
}  // namespace lumaknot
