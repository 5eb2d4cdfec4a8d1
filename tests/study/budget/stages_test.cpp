#include "study/budget/stages.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "meshgen/knot_mesh.h"
#include "scene/presets.h"
#include "study/budget/knot_samples.h"
#include "system/error.h"

namespace lumaknot::budget {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

KnotSpec coarse_knot(int segments) {
  KnotSpec knot;
  knot.segments = segments;
  knot.sides = segments / 6;
  return knot;
}

Scene small_scene(const KnotSpec& knot, std::string_view material) {
  Scene scene{knot_mesh(knot), Vec3d{0.7, 0.4, 0.2}, builtin_scene("figure2")->view};
  scene.view.image = {72, 72, 1};
  scene.view.material = *with_formula({}, material);
  return scene;
}

double rmse_of(const ErrorBudget& budget, std::string_view name) {
  for (const BudgetPart& part : budget.parts) {
    if (part.name == name) return part.rmse;
  }
  ADD_FAILURE() << name;
  return 0;
}

constexpr BudgetOptions kOptions{.samples = 5, .tolerance = 1.0 / 128};

TEST(ErrorBudget, parts_add_up_to_the_whole_within_a_tenth) {
  const KnotSpec knot = coarse_knot(96);
  const ErrorBudget budget = error_budget(small_scene(knot, "yiq-table1"), knot, kOptions);
  EXPECT_GT(budget.whole.rmse, 1e-3);
  EXPECT_LT(budget.share_left(), 0.1);
  for (const std::string_view each : {"tessellation", "sampling", "unnormalised normal"}) {
    EXPECT_GT(rmse_of(budget, each), 1e-4) << each;
  }
  EXPECT_LT(rmse_of(budget, "texture filter"), 1e-15);  // one colour, its mean rounded
  EXPECT_LE(rmse_of(budget, "quantisation"), 0.5 / 255);
}

TEST(ErrorBudget, normals_of_unit_length_and_eq_3_have_no_such_stages) {
  const KnotSpec knot = coarse_knot(96);
  const ErrorBudget budget = error_budget(small_scene(knot, "phong"), knot, kOptions);
  EXPECT_EQ(rmse_of(budget, "unnormalised normal"), 0);
  EXPECT_EQ(rmse_of(budget, "colour space"), 0);
}

// Chords and normals err by the square of the grid's step: a quarter of the step leaves a
// sixteenth; coverage that flips at silhouettes comes and goes, so a fifth is asked for.
TEST(ErrorBudget, finer_grids_leave_less_to_tessellation_and_normals) {
  const KnotSpec coarse = coarse_knot(96), fine = coarse_knot(384);
  const ErrorBudget before = error_budget(small_scene(coarse, "phong"), coarse, kOptions);
  const ErrorBudget after = error_budget(small_scene(fine, "phong"), fine, kOptions);
  for (const std::string_view each : {"tessellation", "normal interpolation"}) {
    EXPECT_LT(rmse_of(after, each), rmse_of(before, each) / 5) << each;
  }
}

TEST(ErrorBudget, a_vertex_of_the_mesh_is_the_tubes_point_at_its_parameters) {
  const KnotSpec knot = coarse_knot(24);
  const TriangleMesh mesh = knot_mesh(knot);
  const KnotGrid grid(knot, mesh);
  Fragment corner;
  corner.triangle = 37;
  corner.weights = {0, 1, 0};
  const std::uint32_t vertex = mesh.triangles[37][1];
  corner.normal = mesh.normals[vertex];
  const KnotSample sample = grid.of_mesh(corner);
  EXPECT_LT(length(grid.exact_normal(sample) - mesh.normals[vertex]), 1e-12);
  Fragment on_tube;
  on_tube.triangle = 0;
  const KnotSample back = grid.of_tube({on_tube, sample.t, sample.theta});
  EXPECT_LT(length(back.seen.normal - mesh.normals[vertex]), 1e-12);
}

TEST(ErrorBudget, text_and_json_tell_every_part) {
  const KnotSpec knot = coarse_knot(24);
  Scene scene = small_scene(knot, "phong");
  scene.view.image = {16, 16, 1};
  const ErrorBudget budget = error_budget(scene, knot, {.samples = 2, .tolerance = 0.1});
  EXPECT_THAT(budget_text(budget), HasSubstr("normal interpolation"));
  EXPECT_EQ(nlohmann::json::parse(budget_json(budget))["parts"].size(), budget.parts.size());
  EXPECT_EQ(budget_picture(budget).width, 4 * 16);
}

TEST(ErrorBudget, refuses_what_it_has_no_stage_for) {
  const KnotSpec knot = coarse_knot(24);
  Scene scene = small_scene(knot, "phong");
  scene.view.material.rate = ShadingFrequency::kVertex;
  EXPECT_THAT([&] { error_budget(scene, knot); }, ThrowsMessage<Error>(HasSubstr("material.rate")));
  scene = small_scene(knot, "phong");
  scene.view.image.samples = 2;
  EXPECT_THAT([&] { error_budget(scene, knot); }, ThrowsMessage<Error>(HasSubstr("image.samples")));
  scene = small_scene(knot, "phong");
  scene.view.image = {8, 8, 1};
  scene.view.camera.target = {0, -10, 2.4};
  EXPECT_THAT([&] { error_budget(scene, knot, kOptions); },
              ThrowsMessage<Error>(HasSubstr("covers no pixel's centre; move camera.position")));
}

}  // namespace
}  // namespace lumaknot::budget
