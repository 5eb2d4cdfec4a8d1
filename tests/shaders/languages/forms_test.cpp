// The lit colour in every space: its forms, its gamut rules, the colours of light and surface.
#include <gtest/gtest.h>

#include "scene/presets.h"
#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// The lit colour of r'g'b' `texture` under grey or coloured terms.
Vec3d lit(const Vec3d& texture, const Terms<double>& terms, const Material& m,
          const View& view = {}) {
  return lit_color(texture_value(texture, m), terms, lighting_of<double>(view, m), m);
}

Terms<double> random_terms(RandomSurface& random) {
  const double diffuse = random.number(0, 1);
  return {grey(diffuse), grey(random.number(0, 1))};
}

TEST(Forms, of_the_linear_spaces_compute_one_colour) {
  RandomSurface random;
  for (const Space space : {Space::kYiq, Space::kYuv601, Space::kYuv709}) {
    // YIQ's matrices are inverse to 1e-7 as printed, times a chroma of up to 1.7; others round.
    const double tolerance = space == Space::kYiq ? 1e-6 : 1e-14;
    for (int i = 0; i < 200; ++i) {
      const Vec3d texture = random.texture();
      const Terms<double> terms = random_terms(random);
      Material m;
      m.space = space;
      const Vec3d matrices = lit(texture, terms, m);
      m.form = Form::kBaked;
      ASSERT_LT(largest_magnitude(lit(texture, terms, m) - matrices),
                1e-15);  // the same operations
      m.form = Form::kCollapsed;
      ASSERT_LT(largest_magnitude(lit(texture, terms, m) - matrices), tolerance) << name_of(space);
    }
  }
}

TEST(Forms, of_every_space_scale_and_shift_the_brightness_alone) {
  RandomSurface random;
  for (const Space space : kLumaSpaces) {
    Material m;
    m.space = space;
    View view;
    view.ambient = 0.25;
    for (int i = 0; i < 100; ++i) {
      const Vec3d texture = random.texture();
      const Terms<double> terms = random_terms(random);
      Axes<double> axes = axes_from_rgb<double>(texture, space);
      axes.brightness = axes.brightness * (0.25 + terms.diffuse.x) + terms.specular.x;
      // The same operations in the same order.
      ASSERT_LT(largest_magnitude(lit(texture, terms, m, view) - rgb_from_axes(axes, space)), 1e-15)
          << name_of(space);
    }
  }
}

TEST(Gamut, clamp_limits_every_channel_of_the_free_colour) {
  RandomSurface random;
  for (const std::string& formula : formula_names()) {
    Material m = *with_formula(Material{}, formula);
    for (int i = 0; i < 20; ++i) {
      const Vec3d texture = random.texture();
      const Terms<double> terms = random_terms(random);
      m.gamut = Gamut::kFree;
      const Vec3d free = lit(texture, terms, m);
      m.gamut = Gamut::kClamp;
      ASSERT_EQ(lit(texture, terms, m), saturate(free)) << formula;
    }
  }
}

TEST(Gamut, chroma_leaves_colours_of_the_cube_and_brings_in_the_others) {
  RandomSurface random;
  for (const std::string& formula : formula_names()) {
    Material m = *with_formula(Material{}, formula);
    m.clamp = Clamp::kFree;
    for (int i = 0; i < 20; ++i) {
      const Vec3d texture = random.texture();
      const Terms<double> terms = random_terms(random);
      m.gamut = Gamut::kFree;
      const Vec3d free = lit(texture, terms, m);
      m.gamut = Gamut::kChroma;
      const Vec3d reduced = lit(texture, terms, m);
      ASSERT_EQ(reduced, saturate(reduced)) << formula;
      // A colour of the cube is split into grey and chroma and recombined: rounding.
      if (free != saturate(free)) continue;
      ASSERT_LT(largest_magnitude(reduced - free), 1e-14) << formula;
    }
  }
}

TEST(Gamut, chroma_keeps_the_hue_in_rgb_too) {
  Material m;
  m.gamut = Gamut::kChroma;
  // 1.5 (0.9, 0.6, 0.2) lies outside; the differences from its luma shrink alike.
  const Vec3d reduced = lit({0.9, 0.6, 0.2}, {grey(1.4), {}}, m);
  const double hue_before = (0.9 - 0.6) / (0.6 - 0.2);
  EXPECT_NEAR((reduced.x - reduced.y) / (reduced.y - reduced.z), hue_before, 1e-12);
  EXPECT_NEAR(reduced.x, 1, 1e-15);
}

TEST(Colours, of_lights_act_on_each_channel_in_rgb) {
  Material m;
  m.diffuse_color = {0.5, 1, 0.25};
  m.specular_color = {0.25, 0.5, 1};
  m.emissive = {0.125, 0.25, 0.5};
  View view;
  view.ambient = 0.5;
  view.ambient_color = {1, 0.5, 0};
  const Terms<double> terms{{1, 0.5, 0.25}, {0.5, 0.25, 1}};
  const Vec3d f = lit({0.5, 0.5, 1}, terms, m, view);
  // T (s_a m_a L_A + m_d L_D) + m_s L_S + m_e, exact in binary.
  EXPECT_EQ(f, (Vec3d{0.5 * (0.5 + 0.5) + 0.125 + 0.125, 0.5 * (0.25 + 0.5) + 0.125 + 0.25,
                      1 * (0 + 0.0625) + 1 + 0.5}));
}

TEST(Colours, of_lights_act_with_their_brightness_in_a_space_of_brightness) {
  for (const Space space : kLumaSpaces) {
    const Vec3d red{1, 0, 0};
    const double expected =
        brightness_of<double>(red, space) / brightness_of<double>({1, 1, 1}, space);
    EXPECT_EQ(relative_brightness(red, space), expected);
    EXPECT_EQ(relative_brightness({1, 1, 1}, space), 1) << name_of(space);
    EXPECT_NEAR(relative_brightness({0, 0, 0}, space), 0, 1e-15) << name_of(space);
  }
  // L* of the sRGB grey 0.5: linear 0.21404, L* 53.389.
  EXPECT_NEAR(relative_brightness({0.5, 0.5, 0.5}, Space::kCielab), 0.53389, 1e-5);
  EXPECT_NEAR(relative_brightness({0, 1, 0}, Space::kYuv709), 0.7152, 1e-15);
}

TEST(Colours, emission_adds_brightness_without_light) {
  Material m;
  m.space = Space::kYuv709;
  m.emissive = {0, 1, 0};
  View view;
  view.ambient = 0;
  const Vec3d f = lit({0.5, 0.5, 0.5}, {{}, {}}, m, view);
  EXPECT_LT(largest_magnitude(f - grey(0.7152)), 1e-15);
}

}  // namespace
}  // namespace lumaknot
