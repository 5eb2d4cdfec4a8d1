#include "study/bench/report.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lumaknot::bench {
namespace {

using ::testing::HasSubstr;

/// Classical frames of 2 ms, YIQ of 2.5 ms, Table 1's of 4 ms.
FrameTimes times() { return {{{2, 2, 2, 2, 9}, {2.5, 2.5, 2.5, 2.5, 11}, {4, 4, 4, 4, 4}}}; }

RateTable table() {
  RateRow ours{.renderer = "lumaknot", .threads = 1, .samples = 8, .how = "trilinear"};
  RateRow gpu{.renderer = "Some <GPU>", .threads = 0, .samples = 1, .how = "until glFinish"};
  const std::vector<FrameTimes> rounds{times(), times()};
  summarise(rounds, ours);
  summarise(rounds, gpu);
  gpu.ratio = 0.25;
  return {720, 480, {ours, gpu}, {{"Embree", "lumaknot-embree not found; build it"}}};
}

TEST(RateReport, cost_is_the_share_of_the_rate_that_is_lost) {
  const RateRow row = table().rows[0];
  EXPECT_EQ(row.milliseconds[0].median, 2);
  EXPECT_EQ(row.milliseconds[0].max, 9);
  EXPECT_EQ(row.costs[0], 0);
  EXPECT_DOUBLE_EQ(row.costs[1], 0.2);  // 500 frames a second become 400
  EXPECT_DOUBLE_EQ(row.costs[2], 0.5);
}

TEST(RateReport, rounds_that_disagree_widen_a_cost_s_interval) {
  const auto of = [](std::vector<FrameTimes> rounds) {
    RateRow row;
    summarise(rounds, row);
    return row.cost_intervals[2];
  };
  const FrameTimes fast{{{2, 2, 2, 2, 2}, {2, 2, 2, 2, 2}, {2, 2, 2, 2, 2}}};
  EXPECT_TRUE(std::isinf(of({times()}).min));  // five pairs
  EXPECT_DOUBLE_EQ(of({times(), times(), times()}).min, 0.5);
  const Interval<double> wide = of({times(), times(), times(), times(), fast});
  EXPECT_EQ(wide.min, 0);
  EXPECT_DOUBLE_EQ(wide.max, 0.5);
}

TEST(RateReport, paper_rows_are_table_2) {
  ASSERT_EQ(paper_rows().size(), 5u);
  // What Table 2 prints next to the rates, in percent.
  const std::vector<double> printed{4.8, 1.0, 32.6, 20.7, 20.5};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const PaperRow& row = paper_rows()[i];
    EXPECT_NEAR(100 * (1 - row.yiq / row.classical), printed[i], 0.05)
        << row.machine;  // its digits
  }
}

TEST(RateReport, text_has_a_line_for_each_row_and_each_missing_renderer) {
  const std::string text = rates_text(table());
  EXPECT_THAT(text, HasSubstr("720 x 480"));
  EXPECT_THAT(text, ::testing::ContainsRegex("lumaknot +1 +8x +500 +400 +20.0 % +250 +50.0 %"));
  EXPECT_THAT(text, ::testing::ContainsRegex("Some <GPU> +- +none +500 .* 0.25 "));
  EXPECT_THAT(text, ::testing::ContainsRegex("GeForce GTS 250 +- +8x +389 +385 +1.0 %"));
  EXPECT_THAT(text, ::testing::ContainsRegex("Embree +missing: lumaknot-embree not found; build"));
}

TEST(RateReport, json_holds_every_row_and_the_paper) {
  const auto json = nlohmann::json::parse(rates_json(table()));
  EXPECT_EQ(json["rows"].size(), 2u);
  EXPECT_EQ(json["rows"][0]["yiq"]["frames_per_second"], 400);
  EXPECT_EQ(json["rows"][0]["classical"]["milliseconds"]["least"], 2);
  EXPECT_EQ(json["missing"][0]["renderer"], "Embree");
  EXPECT_EQ(json["paper"][4]["side"], 512);
}

TEST(RateReport, picture_escapes_names_and_scales_to_the_fastest) {
  const std::string svg = rates_svg(table());
  EXPECT_THAT(svg, HasSubstr("Some &lt;GPU&gt;, 1 sample"));
  EXPECT_THAT(svg, HasSubstr("lumaknot, 1 thread, 8 samples"));
  EXPECT_THAT(svg, HasSubstr("width=\"460.0\""));  // the paper's 1240
  EXPECT_THAT(svg, HasSubstr("width=\"185.5\""));  // 500 of them
}

TEST(RateReport, shots_keep_the_scene_s_numbers) {
  Scene scene;
  scene.view.material.parameters["shininess"] = 7;
  const std::vector<Shot> shots = rate_shots(scene);
  ASSERT_EQ(shots.size(), kRateShots.size());
  for (const Shot& shot : shots) EXPECT_EQ(shot.material.parameters["shininess"], 7);
  EXPECT_EQ(shots[1].material.form, Form::kCollapsed);
  EXPECT_EQ(shots[2].material.form, Form::kMatrices);
  EXPECT_EQ(shots[2].material.clamp, Clamp::kTable1);
}

}  // namespace
}  // namespace lumaknot::bench
