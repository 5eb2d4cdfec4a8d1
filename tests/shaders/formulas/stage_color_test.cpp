// The result of each stage of a shot, and what lighting_of() reads from a scene.
#include <gtest/gtest.h>

#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/formulas/terms_at.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;  // a few operations on numbers near one

TEST(StageColor, shows_the_texture_whatever_the_material) {
  RandomSurface random;
  for (const Shot& shot : every_shot()) {
    if (shot.stage != Stage::kTexture) continue;
    const Vec3d texture = random.texture();
    const Material& m = shot.material;
    const Vec3d shown = stage_color(random.point(), texture_value(texture, m),
                                    lighting_of<double>(random.view(), m), shot);
    // Baked, it comes back from the axes: M and W are inverse to 1e-7.
    EXPECT_LE(largest_magnitude(shown - texture), m.form == Form::kBaked ? 1e-7 : 0) << shot.name;
  }
}

TEST(StageColor, shows_the_terms_of_white_light_as_greys_without_their_weights) {
  View view;
  view.camera.position = {0, 0, 3};
  view.lights = {PointLight{{6, 0, 8}, {}, {}}};
  view.ambient = 0.3;
  for (Shot shot : every_shot()) {
    if (shot.material.model != Model::kPhong) continue;
    shot.material.parameters["shininess"] = 2;
    const Vec3d color = stage_color<double>({{0, 0, 0}, {0, 0, 1}}, {0.9, 0.1, 0.2},
                                            lighting_of<double>(view, shot.material), shot);
    if (shot.stage == Stage::kDiffuse) {
      EXPECT_LT(largest_magnitude(color - grey(0.8)), kRounding);
    } else if (shot.stage == Stage::kSpecular) {
      EXPECT_LT(largest_magnitude(color - grey(0.64)), kRounding);
    }
  }
}

TEST(StageColor, terms_of_white_lights_are_grey_in_every_formula) {
  RandomSurface random;
  View view = random.view();
  view.lights.push_back(DirectionalLight{{-1, 2, -1}, {}});
  view.lights.push_back(SpotLight{{1, -2, 3}, {-1, 2, -3}, 20, 60, {{1, 1, 1}, 0.7}, {1, 0.5, 0}});
  for (const Shot& shot : final_shots()) {
    const Terms<double> terms = terms_of(view, random.point(), shot.material);
    EXPECT_EQ(terms.diffuse, grey(terms.diffuse.x)) << shot.name;
    EXPECT_EQ(terms.specular, grey(terms.specular.x)) << shot.name;
  }
}

TEST(StageColor, terms_are_grey_in_a_space_of_brightness_whatever_the_light_s_colour) {
  RandomSurface random;
  for (const NamedView& view : every_view()) {
    for (const Shot& shot : final_shots()) {
      if (shot.material.space == Space::kRgb) continue;
      const Terms<double> terms = terms_of(view.view, random.point(), shot.material);
      EXPECT_EQ(terms.diffuse, grey(terms.diffuse.x)) << shot.name << view.name;
      EXPECT_EQ(terms.specular, grey(terms.specular.x)) << shot.name << view.name;
    }
  }
}

TEST(LightingOf, takes_the_scene_s_lights_and_the_shot_s_material) {
  View view;
  view.camera.position = {1, 2, 3};
  view.lights = {PointLight{{4, 5, 6}, {}, {0.5, 0.25, 0.125}}};
  view.ambient = 0.7;
  view.material.parameters["shininess"] = 99;
  Material material;
  material.parameters["shininess"] = 8;
  material.parameters["roughness"] = 0.8;
  material.parameters["reflectance"] = 0.7;
  material.parameters["darkness"] = 0.6;
  material.luma_offset = -0.2;
  const auto l = lighting_of<double>(view, material);
  EXPECT_EQ(l.eye_position, (Vec3d{1, 2, 3}));
  ASSERT_EQ(l.lights.size(), 1u);
  EXPECT_EQ(l.lights[0].position, (Vec3d{4, 5, 6}));
  EXPECT_EQ(l.lights[0].constant, 0.5);
  EXPECT_EQ(l.lights[0].linear, 0.25);
  EXPECT_EQ(l.lights[0].quadratic, 0.125);
  EXPECT_EQ(l.parameters["shininess"], 8);
  EXPECT_EQ(l.parameters["roughness"], 0.8);
  EXPECT_EQ(l.parameters["reflectance"], 0.7);
  EXPECT_EQ(l.parameters["darkness"], 0.6);
  EXPECT_EQ(l.luma_offset, -0.2);
}

TEST(LightingOf, multiplies_weights_and_colours_in_space_rgb) {
  View view;
  view.ambient = 0.5;
  view.ambient_color = {0.5, 1, 0.25};
  Material m;
  m.diffuse = 0.5;
  m.specular = 2;
  m.ambient_color = {0.5, 0.25, 1};
  m.diffuse_color = {0.25, 0.5, 0.75};
  m.specular_color = {1, 0.5, 0.25};
  m.emissive = {0.125, 0, 0.5};
  const auto l = lighting_of<double>(view, m);
  EXPECT_EQ(l.ambient, (Vec3d{0.125, 0.125, 0.125}));
  EXPECT_EQ(l.diffuse, (Vec3d{0.125, 0.25, 0.375}));
  EXPECT_EQ(l.specular, (Vec3d{2, 1, 0.5}));
  EXPECT_EQ(l.emissive, (Vec3d{0.125, 0, 0.5}));
}

TEST(LightingOf, takes_the_brightness_of_colours_in_a_space_of_brightness) {
  View view;
  view.ambient = 0.5;
  view.ambient_color = {1, 0, 0};
  view.lights = {DirectionalLight{{0, 0, -1}, {{0, 1, 0}, 2}}};
  Material m;
  m.space = Space::kYuv601;  // luma weights 0.299, 0.587, 0.114
  m.diffuse = 3;
  m.diffuse_color = {0, 0, 1};
  const auto l = lighting_of<double>(view, m);
  EXPECT_LT(largest_magnitude(l.ambient - grey(0.5 * 0.299)), kRounding);
  EXPECT_LT(largest_magnitude(l.diffuse - grey(3 * 0.114)), kRounding);
  EXPECT_LT(largest_magnitude(l.lights[0].color - grey(2 * 0.587)), kRounding);
}

TEST(LightingOf, makes_directions_unit_and_cones_cosines) {
  View view;
  view.lights = {SpotLight{{1, 2, 3}, {0, 3, -4}, 60, 90, {}, {}}, DirectionalLight{{0, 0, 5}, {}}};
  const auto l = lighting_of<double>(view, Material{});
  EXPECT_TRUE(l.lights[0].has_position && l.lights[0].has_cone);
  EXPECT_LT(largest_magnitude(l.lights[0].direction - Vec3d{0, 0.6, -0.8}), kRounding);
  EXPECT_NEAR(l.lights[0].cos_outer, 0, kRounding);
  EXPECT_NEAR(l.lights[0].cone_scale, 2, kRounding);
  EXPECT_FALSE(l.lights[1].has_position || l.lights[1].has_cone);
  EXPECT_EQ(l.lights[1].direction, (Vec3d{0, 0, 1}));
}

}  // namespace
}  // namespace lumaknot
