#include <gtest/gtest.h>

#include "shaders/lighting.h"
#include "tests/shaders/every_shot.h"
#include "tests/shaders/random_surface.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;      // a few operations on numbers near one
constexpr double kPrintedDigits = 1e-6;  // how far M and W are from inverse, times a light of 2

/// Unit weights, L_A and an offset.
Lighting<double> lighting(double ambient, double luma_offset = 0) {
  return {{}, {}, ambient, 1, 1, 55, luma_offset};
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
  const Vec3d color =
      lit_color<double>({0.2, 0.4, 0.6}, {0.5, 0.25}, lighting(0.1), Space::kRgb, Clamp::kFree);
  expect_near(color, {0.37, 0.49, 0.61}, kRounding);
}

TEST(LitColor, weights_scale_their_terms_and_spare_the_ambient_light) {
  Lighting<double> weighted = lighting(0.1);
  weighted.diffuse = 0.5;
  weighted.specular = 2;
  const Vec3d color =
      lit_color<double>({0.2, 0.4, 0.6}, {0.8, 0.1}, weighted, Space::kRgb, Clamp::kFree);
  expect_near(color, {0.3, 0.4, 0.5}, kRounding);  // light 0.5, highlight 0.2
}

TEST(LitColor, equations_6_to_8_change_luma_and_keep_chroma) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d t = random.vector(0, 1);
    const Terms<double> terms{random.number(0, 1), random.number(0, 1)};
    const Vec3d f = lit_color(t, terms, lighting(0.1), Space::kYiq, Clamp::kFree);
    ASSERT_NEAR(luma(f), luma(t) * (0.1 + terms.diffuse) + terms.specular, kPrintedDigits);
    ASSERT_NEAR(chroma_i(f), chroma_i(t), kPrintedDigits);
    ASSERT_NEAR(chroma_q(f), chroma_q(t), kPrintedDigits);
  }
}

TEST(LitColor, yiq_collapses_to_the_texture_plus_a_difference_of_luma) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d t = random.vector(0, 1);
    const Terms<double> terms{random.number(0, 1), random.number(0, 1)};
    const Vec3d f = lit_color(t, terms, lighting(0.1), Space::kYiq, Clamp::kFree);
    const double change = luma(t) * (0.1 + terms.diffuse) + terms.specular - luma(t);
    expect_near(f, t + Vec3d{change, change, change}, kPrintedDigits);
  }
}

TEST(LitColor, full_light_leaves_the_texture_in_both_spaces) {
  const Vec3d t{0.9, 0.3, 0.1};
  const Terms<double> terms{1, 0};
  expect_near(lit_color(t, terms, lighting(0), Space::kRgb, Clamp::kFree), t, kRounding);
  expect_near(lit_color(t, terms, lighting(0), Space::kYiq, Clamp::kFree), t, kPrintedDigits);
}

TEST(LitColor, spaces_agree_on_a_grey_texture) {
  // No chroma to keep: the two models are one.
  for (const double grey : {0.0, 0.3, 1.0}) {
    const Terms<double> terms{0.6, 0.2};
    expect_near(lit_color({grey, grey, grey}, terms, lighting(0.1), Space::kRgb, Clamp::kFree),
                lit_color({grey, grey, grey}, terms, lighting(0.1), Space::kYiq, Clamp::kFree),
                kPrintedDigits);
  }
}

TEST(LitColor, phong_s_highlight_alone_is_exactly_grey_whatever_the_texture) {
  RandomSurface random;
  Lighting<double> specular_only = lighting(0);
  specular_only.diffuse = 0;
  for (int i = 0; i < 300; ++i) {
    const double highlight = random.number(0, 1);
    const Vec3d f = lit_color(random.vector(0, 1), {random.number(0, 1), highlight}, specular_only,
                              Space::kRgb, Clamp::kFree);
    ASSERT_EQ(f, (Vec3d{highlight, highlight, highlight}));
  }
}

TEST(LitColor, yiq_s_highlight_alone_keeps_the_surface_s_chroma) {
  Lighting<double> specular_only = lighting(0);
  specular_only.diffuse = 0;
  const Vec3d copper{0.72, 0.45, 0.2};
  const Vec3d f = lit_color(copper, {0.9, 0.5}, specular_only, Space::kYiq, Clamp::kFree);
  EXPECT_NEAR(luma(f), 0.5, kPrintedDigits);
  EXPECT_NEAR(f.x - f.z, copper.x - copper.z, kPrintedDigits);
}

TEST(LitColor, without_clamps_nothing_is_limited) {
  const Vec3d f = lit_color<double>({1, 1, 1}, {1, 1}, lighting(0.5), Space::kRgb, Clamp::kFree);
  expect_near(f, {2.5, 2.5, 2.5}, kRounding);
  const Vec3d dark = lit_color<double>({1, 0, 0}, {0, 0}, lighting(0), Space::kYiq, Clamp::kFree);
  EXPECT_LT(dark.y, 0);  // chroma without luma lies outside the RGB cube
}

TEST(LitColor, table_1_clamps_the_sum_of_diffuse_and_ambient_light) {
  const Vec3d f =
      lit_color<double>({0.2, 0.4, 0.6}, {0.8, 0}, lighting(0.5), Space::kRgb, Clamp::kTable1);
  expect_near(f, {0.2, 0.4, 0.6}, kRounding);
}

TEST(LitColor, table_1_clamps_the_diffuse_term_before_its_weight) {
  Lighting<double> half = lighting(0);
  half.diffuse = 0.5;
  const Vec3d f = lit_color<double>({1, 1, 1}, {1.5, 0}, half, Space::kRgb, Clamp::kTable1);
  expect_near(f, {0.5, 0.5, 0.5}, kRounding);
}

TEST(LitColor, table_1_clamps_the_colour) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const Vec3d f = lit_color(random.vector(0, 1), {random.number(0, 1), random.number(0, 1)},
                              lighting(0.1, -0.1), Space::kYiq, Clamp::kTable1);
    for (const double c : components(f)) {
      ASSERT_GE(c, 0);
      ASSERT_LE(c, 1);
    }
  }
}

TEST(LitColor, luma_offset_shifts_every_channel_of_yiq_alike) {
  const Vec3d t{0.5, 0.6, 0.7};
  const Vec3d plain = lit_color<double>(t, {0.5, 0.1}, lighting(0.1), Space::kYiq, Clamp::kFree);
  const Vec3d darker =
      lit_color<double>(t, {0.5, 0.1}, lighting(0.1, -0.1), Space::kYiq, Clamp::kFree);
  expect_near(plain - darker, {0.1, 0.1, 0.1}, kRounding);
}

TEST(StageColor, shows_the_texture_untouched_whatever_the_material) {
  RandomSurface random;
  for (const Shot& shot : every_shot()) {
    if (shot.stage != Stage::kTexture) continue;
    const SurfacePoint<double> point = random.point();
    EXPECT_EQ(stage_color(point, random.lighting(), shot), point.texture) << shot.name;
  }
}

TEST(StageColor, shows_the_terms_as_greys_without_their_weights) {
  const SurfacePoint<double> point{{0, 0, 0}, {0, 0, 1}, {0.9, 0.1, 0.2}};
  const Lighting<double> light{{0, 0, 3}, {6, 0, 8}, 0.3, 0.25, 0.125, 2, -0.1};
  for (const Shot& shot : every_shot()) {
    const Vec3d color = stage_color(point, light, shot);
    if (shot.stage == Stage::kDiffuse) expect_near(color, {0.8, 0.8, 0.8}, kRounding);
    if (shot.stage == Stage::kSpecular) expect_near(color, {0.64, 0.64, 0.64}, kRounding);
  }
}

TEST(StageColor, in_single_precision_stays_close_to_double) {
  RandomSurface random;
  for (const Shot& shot : every_shot()) {
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint<double> p = random.point();
      const Lighting<double> l = random.lighting();
      const SurfacePoint<float> pf{narrowed(p.position), narrowed(p.normal), narrowed(p.texture)};
      const Lighting<float> lf{narrowed(l.eye_position), narrowed(l.light_position),
                               float(l.ambient),         float(l.diffuse),
                               float(l.specular),        float(l.shininess),
                               float(l.luma_offset)};
      const Vec3<float> single = stage_color(pf, lf, shot);
      // Half an ulp of 6e-8 in each of a dozen operations, times the exponent 55.
      ASSERT_LT(length(Vec3d{single.x, single.y, single.z} - stage_color(p, l, shot)), 5e-5)
          << shot.name;
    }
  }
}

TEST(LightingOf, takes_the_scene_s_lights_and_the_shot_s_material) {
  View view;
  view.camera.position = {1, 2, 3};
  view.light.position = {4, 5, 6};
  view.ambient = 0.7;
  view.material.shininess = 99;
  Material material;
  material.shininess = 8;
  material.diffuse = 0.9;
  material.specular = 0.6;
  material.luma_offset = -0.2;
  const auto l = lighting_of<double>(view, material);
  EXPECT_EQ(l.eye_position, (Vec3d{1, 2, 3}));
  EXPECT_EQ(l.light_position, (Vec3d{4, 5, 6}));
  EXPECT_EQ(l.ambient, 0.7);
  EXPECT_EQ(l.shininess, 8);
  EXPECT_EQ(l.diffuse, 0.9);
  EXPECT_EQ(l.specular, 0.6);
  EXPECT_EQ(l.luma_offset, -0.2);
}

}  // namespace
}  // namespace lumaknot
