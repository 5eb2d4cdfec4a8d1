// What a plan's text and page say.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "study/measure/method_words.h"
#include "study/plan/outcome.h"
#include "study/plan/wording.h"
#include "tests/study/plan/testing.h"

namespace lumaknot::plan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// This many of 1000 pixels meet the tolerance only by the shift; of the scene's own picture 20.
Plan met_by_the_shift(long long shifted) {
  Plan p;
  p.met = p.chosen.result.met = true;
  p.chosen.result = {.error = 0,
                     .in_place = 0.61,
                     .mean_in_place = 0.27,
                     .covered = 1000,
                     .shifted = shifted,
                     .hidden = 3,
                     .failing = 0,
                     .lacking = 0,
                     .met = true};
  p.reference = p.fast = p.chosen.result;
  p.reference.shifted = 20;
  p.lost_in_place = std::max(0LL, shifted - 20);
  p.chosen.milliseconds = 4;
  p.reference_milliseconds = 40;
  p.fast_milliseconds = 3;
  p.before = p.after = p.in_place = p.errors = Image(2, 2);
  return p;
}

TEST(PlanReport, headline_has_the_shares_in_place_and_by_the_shift_beside_the_scene_s_own) {
  const Plan plan = met_by_the_shift(426);
  const std::string shares =
      "57.4 % of the pixels in place, 42.6 % only by a shift of up to 0.25 pixels";
  const std::string own =
      "he scene's own picture (lumaknot render): 98.0 % of the pixels in place, "
      "2.0 % only by a shift of up to 0.25 pixels; the plan moves 40.6 % of the "
      "pixels out of place";
  for (const std::string& form :
       {plan_text(plan), plan_json(plan), plan_html(plan, "a scene", "")}) {
    EXPECT_THAT(form, HasSubstr("met by the shift: " + shares));
  }
  EXPECT_TRUE(plan_text(plan).starts_with("met by the shift: " + shares));
  EXPECT_THAT(plan_text(plan), HasSubstr(own));
  EXPECT_THAT(plan_json(plan), HasSubstr(own));
  // The page's own apostrophe is escaped.
  EXPECT_THAT(plan_html(plan, "a scene", ""), HasSubstr("98.0 % of the pixels in place"));
}

TEST(PlanReport, is_amber_where_more_than_a_hundredth_of_the_pixels_needs_the_shift) {
  EXPECT_EQ(verdict_of(met_by_the_shift(10)), Verdict::kMet);
  EXPECT_EQ(verdict_of(met_by_the_shift(11)), Verdict::kMetByShift);
  EXPECT_THAT(plan_html(met_by_the_shift(10), "a scene", ""), HasSubstr("<h1 class=\"met\">"));
  EXPECT_THAT(plan_html(met_by_the_shift(11), "a scene", ""), HasSubstr("<h1 class=\"by_shift\">"));
  Plan missed = met_by_the_shift(0);
  missed.met = false;
  EXPECT_EQ(verdict_of(missed), Verdict::kNotMet);
  EXPECT_THAT(plan_html(missed, "a scene", ""), HasSubstr("<h1 class=\"not\">"));
}

TEST(PlanReport, warns_where_it_is_amber) {
  EXPECT_THAT(plan_text(met_by_the_shift(10)), Not(HasSubstr("warning")));
  EXPECT_THAT(plan_json(met_by_the_shift(10)), Not(HasSubstr("warning")));
  const Plan many = met_by_the_shift(450);
  EXPECT_THAT(plan_text(many),
              HasSubstr("warning: 45.0 % of the pixels meet it by the shift alone"));
  EXPECT_THAT(plan_text(many), HasSubstr("try --in-place 99%, --shift 0.05 or more image.samples"));
  EXPECT_THAT(plan_json(many), HasSubstr(R"("warning": "45.0 % of the pixels)"));
  EXPECT_THAT(plan_html(many, "a scene", ""),
              HasSubstr("45.0 % of the pixels meet it by the shift alone"));
}

TEST(PlanReport, compares_the_plan_s_picture_with_the_scene_s_own_row_by_row) {
  const Plan plan = met_by_the_shift(450);
  const std::vector<PictureResult> rows = picture_results(plan);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].result.shifted, 450);
  EXPECT_EQ(rows[1].result.shifted, 20);
  const auto json = nlohmann::json::parse(plan_json(plan));
  EXPECT_EQ(json["in_place"]["pixels"], 550);
  EXPECT_EQ(json["in_place"]["lost_pixels"], 430);
  EXPECT_EQ(json["by_shift_alone"]["share"], 0.45);
  EXPECT_EQ(json["before_reference"]["measured"]["beyond_in_place"], 20);
  EXPECT_EQ(json["chosen"]["measured"]["mean_in_place"], 0.27);
  EXPECT_THAT(plan_text(plan), HasSubstr("55.0 %"));
  EXPECT_THAT(plan_html(plan, "a scene", ""), HasSubstr("45.0 % (450)</td>"));
}

TEST(PlanReport, names_what_is_left_out_and_what_it_changes_in_a_sentence) {
  Plan plan = met_by_the_shift(0);
  plan.share = 0.25 / 255;
  EXPECT_THAT(left_out_in_words(plan), HasSubstr("Nothing can be left out"));
  plan.pruning.dropped = {{"light 2 left out", {}, 0}};
  EXPECT_EQ(left_out_in_words(plan),
            "The one part that is left out changes no pixel's colour at all");
  plan.pruning.dropped.push_back({"ambient light left out", {}, 3e-4});
  plan.pruning.change = 3e-4;
  EXPECT_EQ(left_out_in_words(plan),
            "The 2 parts that are left out together change no pixel's colour by more than 0.0003; "
            "0.00098, 25.0 % of the tolerance, may be spent on what is left out");
}

TEST(PlanReport, names_methods_in_words_and_explains_each_word) {
  Plan plan = met_by_the_shift(0);
  plan.chosen.method = {.segments = 369, .sides = 48, .filter = Filter::kBilinear, .culls = true};
  plan.candidates = {plan.chosen};
  const std::string words =
      "grid 369 x 48, light per pixel in RGB, float, bilinear texture, 1 sample per pixel, back "
      "faces culled";
  const std::string page = plan_html(plan, "a scene", "");
  EXPECT_THAT(plan_text(plan), HasSubstr("planned: " + words));
  EXPECT_THAT(page, HasSubstr("<td>" + words + "</td>"));
  EXPECT_THAT(page, Not(HasSubstr(measure::method_name(plan.chosen.method))));
  for (const measure::MethodTerm& term : measure::method_legend()) {
    // Its end, where no apostrophe is escaped.
    EXPECT_THAT(page, HasSubstr(std::string(term.meaning.substr(term.meaning.size() - 12))));
  }
}

TEST(PlanReport, says_slower_of_what_is_slower) {
  EXPECT_THAT(plan_text(met_by_the_shift(0)),
              HasSubstr("10.0 times faster than the reference (40.0 ms), 1.33 times slower than "
                        "--fast (3.00 ms)"));
  EXPECT_THAT(plan_html(met_by_the_shift(0), "a scene", ""), HasSubstr("1.33 times slower than"));
}

}  // namespace
}  // namespace lumaknot::plan
