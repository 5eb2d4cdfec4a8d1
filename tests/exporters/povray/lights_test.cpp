#include "exporters/povray/lights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/presets.h"
#include "tests/exporters/povray/testing.h"

namespace lumaknot::povray {
namespace {

using testing::color_of;
using testing::expect_near;
using ::testing::HasSubstr;
using testing::kColor;
using testing::kNumber;
using testing::kVector;
using testing::Match;
using testing::matches;
using ::testing::Not;
using testing::vector_of;

constexpr Vec3d kWhite{1, 1, 1};
constexpr double kRounding = 1e-14;  // a few products of numbers near one

std::string lights_text(std::vector<Light> lights, Space space = Space::kRgb,
                        const Vec3d& tint = kWhite) {
  View view;
  view.lights = std::move(lights);
  return pov_lights(view, space, tint);
}

PointLight colored(const Vec3d& rgb, double intensity = 1) {
  return {.position = {1, 2, 3}, .color = {rgb, intensity}, .falloff = {}};
}

Vec3d only_color(const std::string& text) {
  const auto found = matches(text, kVector + " " + kColor);
  EXPECT_EQ(found.size(), 1u) << text;
  return color_of(found.at(0), 4);
}

TEST(PovLights, point_light_is_where_the_scene_says) {
  PointLight light;
  light.position = {1.25, -1e-7, 3e10};
  const auto found = matches(lights_text({light}), "light_source \\{ " + kVector + " rgb 1 \\}");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(vector_of(found[0]), light.position);
}

TEST(PovLights, no_lights_are_no_text_and_several_keep_their_order) {
  EXPECT_EQ(lights_text({}), "");
  const auto found =
      matches(lights_text({colored({1, 0, 0}), colored({0, 0.5, 0})}), kVector + " " + kColor);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(color_of(found[0], 4), (Vec3d{1, 0, 0}));
  EXPECT_EQ(color_of(found[1], 4), (Vec3d{0, 0.5, 0}));
}

TEST(PovLights, color_counts_as_it_is_in_rgb_and_as_its_brightness_in_a_space_of_brightness) {
  const Vec3d rgb{0.5, 1, 0.25};
  expect_near(only_color(lights_text({colored(rgb, 3)})), {1.5, 3, 0.75}, kRounding);
  const double luma = 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;  // BT.709
  expect_near(only_color(lights_text({colored(rgb, 3)}, Space::kYuv709)), kWhite * (3 * luma),
              kRounding);
}

TEST(PovLights, tint_multiplies_every_color) {
  expect_near(only_color(lights_text({colored({0.5, 1, 1})}, Space::kRgb, {1, 0.5, 0.25})),
              {0.5, 0.5, 0.25}, kRounding);
}

TEST(PovLights, parallel_light_shines_in_its_direction) {
  const auto found = matches(lights_text({DirectionalLight{.direction = {3, 0, -4}, .color = {}}}),
                             "light_source \\{ " + kVector + " rgb 1 parallel point_at 0 \\}");
  ASSERT_EQ(found.size(), 1u);
  expect_near(vector_of(found[0]) * -1.0, {0.6, 0, -0.8}, kRounding);
}

TEST(PovLights, spot_aims_along_its_direction_with_both_cones_and_no_tightness) {
  SpotLight spot{.position = {100, 2, 3},
                 .direction = {0, 2, 0},
                 .inner_degrees = 12,
                 .outer_degrees = 34,
                 .color = {},
                 .falloff = {}};
  const auto found =
      matches(lights_text({spot}), kVector +
                                       " rgb 1 spotlight radius 12 falloff 34 tightness 0 "
                                       "point_at " +
                                       kVector);
  ASSERT_EQ(found.size(), 1u);
  expect_near(normalize(vector_of(found[0], 4) - vector_of(found[0])), {0, 1, 0}, kRounding);
}

/// POV-Ray's result for the one light in `text` at distance d: colour times 2 / (1 + (d /
/// fade_distance)^fade_power).
double arriving(const std::string& text, double d) {
  const auto found = matches(text, kVector + " rgb " + kNumber + "(?: fade_distance " + kNumber +
                                       " fade_power " + kNumber + ")?");
  EXPECT_EQ(found.size(), 1u) << text;
  const Match& m = found.at(0);
  const double color = std::stod(m[4]);
  return m[5].empty() ? color : color * 2 / (1 + std::pow(d / std::stod(m[5]), std::stod(m[6])));
}

TEST(PovLights, falloff_is_the_formulas_at_every_distance) {
  const Falloff falloffs[] = {{2, 0, 0},   {1, 0.5, 0},   {0.25, 0, 3}, {0, 2, 0},
                              {0, 0, 0.5}, {1e-12, 1, 0}, {1, 1e-9, 0}, {1e-12, 0, 4}};
  for (const Falloff& f : falloffs) {
    PointLight light = colored(kWhite, 0.8);
    light.falloff = f;
    ASSERT_TRUE(has_pov_falloff(f));
    for (const double d : {0.01, 0.3, 1.0, 7.0, 1000.0}) {
      const double expected = 0.8 / (f.constant + f.linear * d + f.quadratic * d * d);
      // Without a constant the 1 in POV-Ray's formula stays: 1e-8 / d of the light at power 1.
      EXPECT_NEAR(arriving(lights_text({light}), d) / expected, 1, 1e-8 / d + kRounding)
          << f.constant << " " << f.linear << " " << f.quadratic << " at " << d;
    }
  }
}

TEST(PovLights, two_powers_of_falloff_at_once_are_not_available) {
  EXPECT_FALSE(has_pov_falloff({1, 0.1, 0.1}));
  EXPECT_FALSE(has_pov_falloff({0, 0.1, 0.1}));
}

TEST(PovLights, texture_stage_needs_none) {
  const Scene scene = testing::small_scene();
  EXPECT_THAT(testing::scene_text(scene, Stage::kTexture, Material{}),
              Not(HasSubstr("light_source")));
  EXPECT_THAT(testing::scene_text(scene, Stage::kFinal, Material{}), HasSubstr("light_source"));
}

}  // namespace
}  // namespace lumaknot::povray
