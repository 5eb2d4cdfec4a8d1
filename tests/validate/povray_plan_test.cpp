#include "validate/renderers/povray_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/shot.h"
#include "tests/validate/small_scene.h"

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;

Shot shot(std::string_view formula, Stage stage = Stage::kFinal) {
  return {std::string(formula), stage, *with_formula(Material{}, formula)};
}

PovPlan plan(const Scene& scene, const std::vector<Shot>& shots) {
  return plan_povray(scene, shots, "", "MESH\n");
}

TEST(PovPlan, shots_that_look_the_same_share_a_frame) {
  const PovPlan p = plan(testing::small_scene(),
                         {shot("yiq-phong"), shot("rgb-phong"), shot("yiq-collapsed-phong"),
                          shot("yiq-baked-phong"), shot("rgb-phong", Stage::kTexture)});
  EXPECT_EQ(p.frames.size(), 3u);
  EXPECT_EQ(p.shots[0].frame, 0u);
  EXPECT_EQ(p.shots[1].frame, 1u);
  EXPECT_EQ(p.shots[2].frame, 0u);
  EXPECT_EQ(p.shots[3].frame, 0u);
  EXPECT_EQ(p.shots[4].frame, 2u);
}

TEST(PovPlan, composed_shots_take_the_stages_that_are_drawn_anyway) {
  const PovPlan p = plan(testing::small_scene(),
                         {shot("rgb-phong", Stage::kTexture), shot("rgb-phong", Stage::kDiffuse),
                          shot("rgb-phong", Stage::kSpecular), shot("yiq-table1"),
                          shot("cielab-phong"), shot("cielab-blinn-phong")});
  EXPECT_EQ(p.frames.size(), 4u) << "Blinn's highlight is one more";
  for (const std::size_t i : {3u, 4u, 5u}) {
    EXPECT_FALSE(p.shots[i].frame);
    ASSERT_TRUE(p.shots[i].parts);
    EXPECT_EQ(p.shots[i].parts->texture, 0u);
    EXPECT_EQ(p.shots[i].parts->diffuse, 1u);
    EXPECT_EQ(p.shots[i].parts->specular, i == 5 ? 3u : 2u);
    EXPECT_EQ(p.shots[i].parts->brightness, 1);
  }
}

TEST(PovPlan, spaces_that_see_a_colored_light_otherwise_get_terms_of_their_own) {
  Scene scene = testing::small_scene();
  scene.view.lights = {
      PointLight{.position = {2, -2, 2}, .color = {{1, 0.5, 0}, 1}, .falloff = {}}};
  const PovPlan p =
      plan(scene, {shot("rgb-phong", Stage::kDiffuse), shot("cielab-phong"), shot("din99-phong")});
  EXPECT_NE(p.shots[1].parts->diffuse, p.shots[0].frame);
  EXPECT_NE(p.shots[1].parts->diffuse, p.shots[2].parts->diffuse);
}

TEST(PovPlan, terms_without_weight_are_not_drawn) {
  Shot matte = shot("cielab-cook-torrance");
  matte.material.specular = 0;
  const PovPlan p = plan(testing::small_scene(), {matte});
  ASSERT_TRUE(p.shots[0].parts);
  EXPECT_TRUE(p.shots[0].parts->diffuse);
  EXPECT_FALSE(p.shots[0].parts->specular);
}

TEST(PovPlan, what_can_not_be_composed_draws_nothing_and_tells_why) {
  const PovPlan p = plan(testing::small_scene(), {shot("cielab-cook-torrance")});
  EXPECT_TRUE(p.frames.empty());
  EXPECT_FALSE(p.shots[0].frame || p.shots[0].parts);
  EXPECT_THAT(p.shots[0].why, HasSubstr("nearest"));
}

TEST(PovPlan, terms_beyond_white_are_drawn_by_so_much_weaker_lights) {
  Scene scene = testing::small_scene();
  scene.view.lights = {PointLight{}, PointLight{}, PointLight{}};
  const PovPlan p = plan(scene, {shot("cielab-phong")});
  EXPECT_EQ(p.shots[0].parts->brightness, 3);
  EXPECT_THAT(p.frames.at(*p.shots[0].parts->diffuse), HasSubstr("rgb 0.3333333333333333 }"));
}

TEST(BrightestLight, sums_what_lights_send_where_the_mesh_is_nearest) {
  Scene scene = testing::small_scene();
  const auto bound = [&](std::vector<Light> lights) {
    scene.view.lights = std::move(lights);
    return brightest_light(scene.mesh, scene.view, Space::kRgb);
  };
  EXPECT_EQ(bound({}), 0);
  EXPECT_EQ(bound({DirectionalLight{.direction = {0, 0, -1}, .color = {{0.5, 1, 0}, 2}}}), 2);
  const PointLight far{.position = {0, 0, 100}, .color = {}, .falloff = {0, 0, 1}};
  // The knot lies within 0.58 of the plane z = 0, and its triangles are shorter than 0.2.
  EXPECT_GE(bound({far}), 1 / (100 * 100.0));
  EXPECT_LE(bound({far}), 1 / (99.2 * 99.2));
  PointLight touching = far;
  touching.position = scene.mesh.positions[0];
  EXPECT_EQ(bound({touching}), 1e6) << "where the formula's own guard stops it";
}

}  // namespace
}  // namespace lumaknot::validate
