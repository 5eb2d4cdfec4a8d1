#include "scene/presets.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/check.h"
#include "scene/json.h"

namespace lumaknot {
namespace {

TEST(Presets, every_named_scene_exists_and_is_valid) {
  std::set<std::string_view> names;
  for (const NamedScene& scene : named_scenes()) {
    names.insert(scene.name);
    EXPECT_FALSE(scene.about.empty()) << scene.name;
    ASSERT_TRUE(builtin_scene(scene.name)) << scene.name;
    EXPECT_NO_THROW(check_scene(*builtin_scene(scene.name))) << scene.name;
  }
  EXPECT_EQ(names.size(), named_scenes().size());
}

TEST(Presets, an_unknown_scene_or_material_is_nothing) {
  EXPECT_FALSE(builtin_scene("figure3"));
  EXPECT_FALSE(builtin_scene(""));
  EXPECT_FALSE(with_formula(Material{}, "yiq"));
}

TEST(Presets, figure_2_has_the_paper_s_counts_and_picture) {
  const SceneSpec scene = *builtin_scene("figure2");
  const auto& knot = std::get<KnotSpec>(scene.mesh);
  EXPECT_EQ((knot.segments + 1) * (knot.sides + 1), 31529);
  EXPECT_EQ(2 * knot.segments * knot.sides, 61440);
  EXPECT_TRUE(std::holds_alternative<Bricks>(scene.texture));
  EXPECT_EQ(scene.view.image.width, 720);
  EXPECT_EQ(scene.view.image.height, 720);
  EXPECT_EQ(scene.view.image.samples, 1);
}

TEST(Presets, figure_1_lights_the_knot_from_the_front_and_from_the_back) {
  const auto facing = [](std::string_view name) {
    const View view = builtin_scene(name)->view;
    const Vec3d to_eye = normalize(view.camera.position - view.camera.target);
    const Vec3d light = std::get<PointLight>(view.lights.at(0)).position;
    return dot(normalize(light - view.camera.target), to_eye);
  };
  EXPECT_GT(facing("figure1-front"), 0.5);  // within 60 degrees of the eye
  EXPECT_LT(facing("figure1-back"), -0.5);
}

TEST(Presets, figure_1_specular_shows_the_highlight_alone) {
  const View view = builtin_scene("figure1-specular")->view;
  EXPECT_EQ(view.ambient, 0);
  EXPECT_EQ(view.material.diffuse, 0);
  EXPECT_GT(view.material.specular, 0);
}

TEST(Presets, figure_1_s_views_share_mesh_and_camera) {
  const std::string front = scene_to_json(*builtin_scene("figure1-front"));
  for (const char* name : {"figure1-back", "figure1-specular"}) {
    SceneSpec scene = *builtin_scene(name);
    const SceneSpec reference = *builtin_scene("figure1-front");
    scene.view.lights = reference.view.lights;
    scene.view.ambient = reference.view.ambient;
    scene.view.material = reference.view.material;
    EXPECT_EQ(scene_to_json(scene), front) << name;
  }
}

TEST(Presets, phong_is_equation_3) {
  const Material m = *with_formula(Material{}, "phong");
  EXPECT_EQ(m.space, Space::kRgb);
  EXPECT_EQ(m.luma_offset, 0);
  EXPECT_EQ(m.clamp, Clamp::kFree);
  EXPECT_EQ(m.normal, NormalUse::kUnit);
}

TEST(Presets, yiq_eq6_is_equations_6_to_8) {
  const Material m = *with_formula(Material{}, "yiq-eq6");
  EXPECT_EQ(m.space, Space::kYiq);
  EXPECT_EQ(m.luma_offset, 0);
  EXPECT_EQ(m.clamp, Clamp::kFree);
  EXPECT_EQ(m.normal, NormalUse::kUnit);
}

TEST(Presets, yiq_table1_is_the_listing) {
  const Material m = *with_formula(Material{}, "yiq-table1");
  EXPECT_EQ(m.space, Space::kYiq);
  EXPECT_EQ(m.luma_offset, -0.1);
  EXPECT_EQ(m.clamp, Clamp::kTable1);
  EXPECT_EQ(m.normal, NormalUse::kInterpolated);
  EXPECT_EQ(m.parameters["shininess"], 55);
}

}  // namespace
}  // namespace lumaknot
