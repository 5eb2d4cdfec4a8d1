#include "study/paper/appearance_claims.h"
#include "study/paper/outlook_claims.h"
#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

const Image kRed = filled({0.7f, 0.2f, 0.15f}), kGrey = filled({0.3f, 0.3f, 0.3f}),
            kBlue = filled({0.15f, 0.2f, 0.7f}), kBlack = filled({0, 0, 0}),
            kDarkRed = filled({0.07f, 0.02f, 0.015f});

LookPictures look(const Image& phong, const Image& yiq) {
  return {kRed, phong, yiq, everywhere(), everywhere(), everywhere()};
}

TEST(PaperLook, like_pictures_are_similar_and_other_colors_are_not) {
  EXPECT_EQ(ruling_of(front_similar_claim(look(kRed, kRed))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(front_similar_claim(look(kRed, kBlue))), Ruling::kDoesNotHold);
}

TEST(PaperLook, no_worse_means_no_more_turned_and_no_more_cut_off) {
  EXPECT_EQ(ruling_of(no_worse_claim(look(kRed, kRed))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(no_worse_claim(look(kRed, kBlue))), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(no_worse_claim(look(kRed, filled({0.15f, 0.2f, 1.4f})))),
            Ruling::kDoesNotHold);
}

TEST(PaperLook, a_dark_red_is_no_grey_shade_though_its_chroma_is_small) {
  EXPECT_EQ(ruling_of(phong_back_claim(look(kGrey, kRed))), Ruling::kHolds);
  const PaperClaim dark = phong_back_claim(look(kDarkRed, kRed));
  EXPECT_EQ(ruling_of(dark), Ruling::kHoldsInPart);
  EXPECT_TRUE(measure(dark, "chroma in the shadow").meets());
  EXPECT_FALSE(measure(dark, "saturation in the shadow").meets());
  EXPECT_EQ(ruling_of(phong_back_claim(look(kRed, kRed))), Ruling::kDoesNotHold);
}

TEST(PaperLook, a_shade_is_not_grey_when_it_keeps_chroma_and_hue) {
  EXPECT_EQ(ruling_of(yiq_back_claim(look(kGrey, kRed))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(yiq_back_claim(look(kGrey, kBlue))), Ruling::kHoldsInPart);
  const PaperClaim grey = yiq_back_claim(look(kGrey, kGrey));
  EXPECT_FALSE(measure(grey, "chroma in the shadow").meets());
}

TEST(PaperLook, grey_whatever_the_texture_needs_one_grey_for_all) {
  EXPECT_EQ(ruling_of(phong_grey_claim({kGrey, kGrey})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(phong_grey_claim({kGrey, kBlack})), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(phong_grey_claim({kGrey, kRed})), Ruling::kDoesNotHold);
}

TEST(PaperLook, a_highlight_keeps_the_color_when_it_has_chroma_and_hue) {
  EXPECT_EQ(ruling_of(yiq_keeps_claim(look(kGrey, kRed))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(yiq_keeps_claim(look(kGrey, kBlue))), Ruling::kHoldsInPart);
}

TEST(PaperLook, a_metal_is_nearer_than_phong_and_black_where_no_light_falls) {
  LookPictures p = look(kGrey, kDarkRed);
  p.unlit = Marks(16, 0);
  EXPECT_EQ(ruling_of(metal_claim(p, kDarkRed)), Ruling::kHolds);
  p.unlit = everywhere();
  EXPECT_EQ(ruling_of(metal_claim(p, kDarkRed)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(metal_claim(p, kGrey)), Ruling::kDoesNotHold);
}

TEST(PaperLook, what_only_people_can_judge_has_numbers_and_no_verdict) {
  const PaperClaim claim = any_angle_claim({{kRed, kRed}, {kRed, kBlue}});
  EXPECT_EQ(ruling_of(claim), Ruling::kNotMeasurable);
  EXPECT_GT(measure(claim, "most mean turn of the hue").value, 90);
  EXPECT_FALSE(claim.beyond.empty());
  EXPECT_EQ(ruling_of(complex_scenes_claim(0.1, 0.01)), Ruling::kNotMeasurable);
}

TEST(PaperOutlook, minnaert_must_brighten_in_yiq_and_more_than_in_rgb) {
  const Image bright = filled({0.8f, 0.3f, 0.25f});
  EXPECT_EQ(ruling_of(minnaert_claim(kRed, kRed, bright)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(minnaert_claim(kRed, bright, bright)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(minnaert_claim(kRed, kRed, kRed)), Ruling::kDoesNotHold);
}

TEST(PaperOutlook, models_benefit_by_chroma) {
  EXPECT_EQ(ruling_of(models_claim(kRed, {{"a", kDarkRed, kRed}})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(models_claim(kRed, {{"a", kDarkRed, kRed}, {"b", kRed, kRed}})),
            Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(models_claim(kRed, {{"b", kRed, kRed}})), Ruling::kDoesNotHold);
}

TEST(PaperOutlook, more_real_is_nearer_to_the_picture_of_linear_light) {
  const RealPictures nearer{kRed, kGrey, kRed}, farther{kRed, kRed, kGrey};
  EXPECT_EQ(ruling_of(realism_claim(nearer, nearer)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(realism_claim(nearer, farther)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(realism_claim(farther, farther)), Ruling::kDoesNotHold);
}

TEST(PaperOutlook, a_space_whose_picture_is_no_numbers_cannot_be_used) {
  const Image broken = with_first(kRed, {NAN, 0, 0});
  EXPECT_EQ(ruling_of(spaces_claim({{"yiq", kRed, 30}})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(spaces_claim({{"yiq", broken, 30}})), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(spaces_claim({{"yiq", broken, 600}})), Ruling::kDoesNotHold);
}

TEST(PaperOutlook, slow_means_below_thirty_frames_or_twice_the_time) {
  const auto times = [](double yiq, double cie) {
    std::vector<FormulaTime> all;
    for (const char* name :
         {"yiq-phong", "cielab-phong", "cieluv-phong", "din99-phong", "atd95-phong"}) {
      const double ms = all.empty() ? yiq : cie;
      all.push_back({name, {ms, ms, ms}, 0});
    }
    return all;
  };
  EXPECT_EQ(ruling_of(slow_spaces_claim(times(10, 50))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(slow_spaces_claim(times(5, 11))), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(slow_spaces_claim(times(10, 11))), Ruling::kDoesNotHold);
}

TEST(PaperOutlook, greater_accuracy_is_less_turn_of_the_hue_than_yiq) {
  const auto spaces = [](const Image& yiq, const Image& atd95, const Image& din99) {
    return std::vector<SpacePicture>{{"yiq", yiq, 0}, {"atd95", atd95, 0}, {"din99", din99, 0}};
  };
  const auto ruling = [&](const Image& yiq, const Image& atd95, const Image& din99) {
    return ruling_of(perceptual_claim(kRed, spaces(yiq, atd95, din99), everywhere()));
  };
  EXPECT_EQ(ruling(kBlue, kRed, kRed), Ruling::kHolds);
  EXPECT_EQ(ruling(kRed, kRed, kBlue), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling(kRed, kBlue, kBlue), Ruling::kDoesNotHold);
}

}  // namespace
}  // namespace lumaknot::paper
