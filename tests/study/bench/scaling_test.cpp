#include "study/bench/scaling.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "meshgen/knot_mesh.h"

namespace lumaknot::bench {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// Ten times the work in twice the time, then twice the work in twice the time.
std::vector<Scaling> scalings() {
  return {{"triangles", {{"10 triangles", 10, {2, 1, 3}}, {"100 triangles", 100, {4, 4, 4}}}},
          {"samples", {{"1 samples", 1, {1, 1, 1}}, {"2 samples", 2, {2, 2, 2}}}}};
}

TEST(Scaling, slope_of_linear_growth_is_one) {
  EXPECT_DOUBLE_EQ(slope_of(scalings()[1], 1), 1);
  EXPECT_NEAR(slope_of(scalings()[0], 1), 0.30103, 1e-5);  // log10 of 2
}

TEST(Scaling, text_has_a_slope_for_each_step_but_the_first) {
  const std::string text = scaling_text(scalings());
  EXPECT_THAT(text, ContainsRegex("10 triangles +2.00 *\n"));
  EXPECT_THAT(text, ContainsRegex("100 triangles +4.00 +0.30\n"));
}

TEST(Scaling, json_holds_every_step) {
  const auto json = nlohmann::json::parse(scaling_json(scalings()));
  EXPECT_EQ(json["triangles"].size(), 2u);
  EXPECT_EQ(json["triangles"][0]["milliseconds"]["most"], 3);
  EXPECT_EQ(json["samples"][1]["slope"], 1);
}

// A decade of work across, and no more than a decade upwards.
TEST(Scaling, chart_draws_each_growth_from_the_same_corner) {
  const std::string svg = scaling_svg(scalings());
  EXPECT_THAT(svg, HasSubstr("points=\"60.0,480.0 710.0,"));
  EXPECT_THAT(svg, HasSubstr("100 triangles: 4.00 ms"));
}

TEST(Scaling, is_measured_of_pixels_and_samples_and_of_a_knots_triangles) {
  KnotSpec knot;
  knot.segments = 12;
  knot.sides = 4;
  Scene scene{knot_mesh(knot), Vec3d{1, 1, 1}, {}};
  scene.view.image = {16, 16, 1};
  const ScalingOptions options{.threads = 1, .seconds = 0};
  const std::vector<Scaling> all = measure_scaling(scene, knot, options, {});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].steps[1].work, 96);
  EXPECT_EQ(all[1].steps.back().name, "128 x 128 pixels");
  EXPECT_EQ(all[2].steps.back().work, 16);
  for (const Scaling& scaling : all) {
    for (const ScalingStep& step : scaling.steps) EXPECT_GT(step.milliseconds.min, 0);
  }
  EXPECT_EQ(measure_scaling(scene, MeshFile{"mesh.obj"}, options, {}).size(), 2u);
}

}  // namespace
}  // namespace lumaknot::bench
