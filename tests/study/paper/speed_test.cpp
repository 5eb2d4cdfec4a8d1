#include "study/paper/speed_claims.h"
#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

/// A row of one thread whose listing costs `cost`, give or take `noise`.
bench::RateRow row(const std::string& renderer, double cost, double milliseconds = 10,
                   double noise = 0) {
  bench::RateRow r;
  r.renderer = renderer;
  r.threads = 1;
  r.milliseconds.fill({milliseconds, milliseconds, milliseconds});
  r.costs = {0, cost, cost};
  r.cost_intervals.fill({cost - noise, cost + noise});
  return r;
}

Forms forms(int rgb, int matrices, int collapsed, int baked, double baked_ms, double baked_cost) {
  return {rgb,
          matrices,
          collapsed,
          baked,
          {{"rgb-phong", {10, 10, 10}, 0},
           {"yiq-phong", {11, 11, 11}, 0.09},
           {"yiq-collapsed-phong", {10.5, 10, 11}, 0.05},
           {"yiq-baked-phong", {baked_ms, baked_ms, baked_ms}, baked_cost},
           {"yiq-table1-phong", {11, 11, 11}, 0.09}},
          0};
}

TEST(PaperSpeed, the_counts_name_one_grid) {
  EXPECT_EQ(ruling_of(grid_claim(31529, 61440)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(grid_claim(30720, 61440)), Ruling::kHoldsInPart);  // without seams
}

TEST(PaperSpeed, the_text_of_table_2_follows_from_its_rates_but_for_its_32_percent) {
  const PaperClaim claim = table_claim(bench::paper_rows());
  EXPECT_EQ(ruling_of(claim), Ruling::kHoldsInPart);
  EXPECT_FALSE(measure(claim, "most, as high as 32 %").meets());  // 32.6
  EXPECT_TRUE(measure(claim, "GTS 250, 8x").meets());
  EXPECT_NEAR(measure(claim, "a frame takes longer by at most").value, 48.3, 0.1);
}

TEST(PaperSpeed, slower_in_all_instances_needs_every_row_decided) {
  const auto claim = [](const bench::RateRow& a, const bench::RateRow& b) {
    return slower_claim(std::vector{a, b});
  };
  EXPECT_EQ(ruling_of(claim(row("a", 0.1), row("b", 0.02))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(claim(row("a", 0.1), row("b", -0.02))), Ruling::kDoesNotHold);
  const PaperClaim half = claim(row("a", 0.1), row("b", 0.001));
  EXPECT_EQ(ruling_of(half), Ruling::kNotMeasurable);
  EXPECT_EQ(measure(half, "rows not decided").value, 1);
  EXPECT_THAT(half.beyond, ::testing::HasSubstr("1 of 2 rows"));
}

TEST(PaperSpeed, what_turns_on_noise_is_not_decided) {
  const auto noisy = [](double cost) { return row("a", cost, 10, 0.02); };
  EXPECT_EQ(ruling_of(slower_claim(std::vector{noisy(0.02)})), Ruling::kNotMeasurable);
  EXPECT_EQ(ruling_of(slower_claim(std::vector{noisy(-0.02)})), Ruling::kNotMeasurable);
  EXPECT_EQ(ruling_of(slower_claim(std::vector{noisy(0.03)})), Ruling::kHolds);
  const PaperClaim cost = cost_claim(std::vector{noisy(0.01), noisy(0.15)}, bench::paper_rows());
  EXPECT_EQ(ruling_of(cost), Ruling::kHolds) << "of the most alone";
  EXPECT_FALSE(measure(cost, "least cost here").is_bound());
  EXPECT_THAT(cost.beyond, ::testing::HasSubstr("the least cost here is from -1.5 to 3.5 %"));
  EXPECT_EQ(ruling_of(cost_claim(std::vector{noisy(0.01)}, bench::paper_rows())),
            Ruling::kNotMeasurable);
}

TEST(PaperSpeed, costs_are_held_to_those_of_the_papers_table) {
  const auto ruling = [](double min, double max) {
    return ruling_of(cost_claim(std::vector{row("a", min), row("b", max)}, bench::paper_rows()));
  };
  EXPECT_EQ(ruling(0.02, 0.3), Ruling::kHolds);
  EXPECT_EQ(ruling(0.001, 0.3), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling(0.001, 0.5), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, real_time_is_thirty_frames_a_second_on_one_thread) {
  bench::RateRow many = row("many threads", 0, 100);
  many.threads = 2;
  EXPECT_EQ(ruling_of(real_time_claim(std::vector{row("a", 0, 10), many})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(real_time_claim(std::vector{row("a", 0, 10), row("b", 0, 100)})),
            Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(real_time_claim(std::vector{row("b", 0, 100)})), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, glsl_is_held_to_what_hlsl_costs_in_the_paper) {
  const auto claim = [](const std::vector<bench::RateRow>& rows) {
    return glsl_speed_claim(rows, bench::paper_rows(), {});
  };
  EXPECT_EQ(ruling_of(claim({row("llvmpipe", 0.02), row("other", 0.9)})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(claim({row("llvmpipe", 0.2)})), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, without_llvmpipe_there_is_the_reason_and_a_number) {
  const std::vector<bench::MissingRates> missing{{"llvmpipe", "libEGL not found"}};
  const PaperClaim claim = glsl_speed_claim({}, bench::paper_rows(), missing);
  EXPECT_EQ(ruling_of(claim), Ruling::kNotMeasurable);
  EXPECT_EQ(claim.beyond, "libEGL not found");
  EXPECT_FALSE(claim.measures.empty());
}

TEST(PaperSpeed, half_of_the_conversions_is_two_to_three_fifths) {
  EXPECT_EQ(ruling_of(half_claim(forms(20, 30, 24, 25, 10, 0))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(half_claim(forms(20, 30, 24, 21, 10, 0))), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, conversions_are_quick_by_slots_and_by_time) {
  EXPECT_EQ(ruling_of(fast_conversion_claim(forms(28, 33, 31, 30, 10, 0))),
            Ruling::kHoldsInPart);  // few slots, but 9 % of the rate
  Forms quick = forms(28, 33, 31, 30, 10, 0);
  quick.times[1].cost = 0.01;
  EXPECT_EQ(ruling_of(fast_conversion_claim(quick)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(fast_conversion_claim(forms(20, 33, 31, 30, 10, 0))), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, the_most_efficient_form_has_the_fewest_slots_and_the_shortest_time) {
  EXPECT_EQ(ruling_of(most_efficient_claim(forms(20, 30, 26, 25, 10, 0))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(most_efficient_claim(forms(20, 30, 26, 25, 12, 0))), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(most_efficient_claim(forms(20, 30, 24, 25, 12, 0))), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, an_optimised_form_has_fewer_slots_and_the_same_picture) {
  Forms f = forms(20, 30, 24, 25, 10, 0);
  EXPECT_EQ(ruling_of(collapsed_claim(f)), Ruling::kHolds);
  f.collapsed_differs = 0.01;
  EXPECT_EQ(ruling_of(collapsed_claim(f)), Ruling::kHoldsInPart);
  f.collapsed_slots = 30;
  EXPECT_EQ(ruling_of(collapsed_claim(f)), Ruling::kDoesNotHold);
}

TEST(PaperSpeed, an_output_in_yiq_has_a_number_and_no_verdict) {
  const PaperClaim claim = rgb_output_claim(forms(20, 30, 24, 25, 10, 0));
  EXPECT_EQ(ruling_of(claim), Ruling::kNotMeasurable);
  EXPECT_EQ(measure(claim, "slots of the conversion back").value, 5);
}

TEST(PaperSpeed, no_compromise_is_one_percent) {
  EXPECT_EQ(ruling_of(no_compromise_claim(forms(20, 30, 24, 25, 10, 0.005))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(no_compromise_claim(forms(20, 30, 24, 25, 10, 0.05))), Ruling::kDoesNotHold);
}

}  // namespace
}  // namespace lumaknot::paper
