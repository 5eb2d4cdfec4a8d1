#include "shaders/spaces/yiq.h"
#include "study/paper/formula_claims.h"
#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

/// Light from straight above, seen from the side, at several tilts of the surface.
std::vector<LitPoint> lit_points(double sign) {
  std::vector<LitPoint> points;
  for (const double x : {0.0, 0.1, 0.3, 0.6}) {
    const PrintedDirections d{normalize(Vec3d{x, 0, 1}), {0, 0, 1}, normalize(Vec3d{0.5, 0, 1})};
    const Vec3d reflection = d.n * (2 * dot(d.l, d.n)) - d.l;
    points.push_back({d, sign * dot(d.l, d.n), std::pow(std::max(dot(reflection, d.v), 0.0), 10)});
  }
  return points;
}

TEST(PaperFormulas, eq1_as_worded_lights_the_far_side) {
  EXPECT_EQ(ruling_of(eq1_claim(lit_points(1))), Ruling::kDoesNotHold);
  std::vector<LitPoint> far = lit_points(1);
  for (LitPoint& p : far) p.directions.l = -p.directions.l;  // L_D of the wording
  EXPECT_EQ(ruling_of(eq1_claim(far)), Ruling::kHolds);
}

TEST(PaperFormulas, light_outside_its_range_is_reported) {
  EXPECT_EQ(ruling_of(delimited_claim(lit_points(1))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(delimited_claim(lit_points(-1))), Ruling::kHoldsInPart);
}

TEST(PaperFormulas, eq2_is_phong_only_with_its_normal_and_exponent) {
  const PaperClaim claim = eq2_claim(lit_points(1), 10);
  EXPECT_EQ(ruling_of(claim), Ruling::kHoldsInPart);
  EXPECT_LT(measure(claim, "largest difference with n and exponent put back").value, 1e-12);
  EXPECT_EQ(ruling_of(eq2_claim(lit_points(1), 3)), Ruling::kDoesNotHold);  // not that exponent
}

TEST(PaperFormulas, eq2_as_printed_takes_a_number_from_each_component) {
  const PrintedDirections d{{0, 0, 1}, {0, 0, 1}, {0, -1, 0}};  // l - (2, 2, 2) = (-2, -2, -1)
  EXPECT_DOUBLE_EQ(eq2_as_printed(d), 2);
  EXPECT_DOUBLE_EQ(eq2_with_n(d), 0);
}

TEST(PaperFormulas, a_range_holds_only_to_its_printed_decimals) {
  YiqMatrices m = paper_matrices();
  EXPECT_EQ(ruling_of(ranges_claim(m)), Ruling::kHoldsInPart);  // I: 0.59598, printed as 0.5957
  m.from_rgb.rows[1] = {0.5957, -0.274, -0.3217};
  EXPECT_EQ(ruling_of(ranges_claim(m)), Ruling::kHolds);
  for (Vec3d& row : m.from_rgb.rows) row = row * 2.0;
  EXPECT_EQ(ruling_of(ranges_claim(m)), Ruling::kDoesNotHold);
}

TEST(PaperFormulas, matrices_that_are_not_inverses_are_reported) {
  YiqMatrices m = paper_matrices();
  EXPECT_EQ(ruling_of(inverse_claim(m)), Ruling::kHolds);
  m.to_rgb.rows[0].y += 1e-6;
  EXPECT_EQ(ruling_of(inverse_claim(m)), Ruling::kDoesNotHold);
}

TEST(PaperFormulas, a_column_of_ones_needs_greys_without_chroma) {
  YiqMatrices m = paper_matrices();
  EXPECT_EQ(ruling_of(ones_claim(m)), Ruling::kHolds);
  for (Vec3d& row : m.from_rgb.rows) row.x += 0.01;
  EXPECT_EQ(ruling_of(ones_claim(m)), Ruling::kDoesNotHold);
}

TEST(PaperFormulas, luma_is_measured_against_luminance) {
  const PaperClaim claim = luma_claim(kYiqFromRgb[0]);
  EXPECT_EQ(ruling_of(claim), Ruling::kDoesNotHold);
  // Pure blue: 0.11448 next to the encoding of sRGB's 0.0722, 0.29787.
  EXPECT_NEAR(measure(claim, "least ratio").value, 0.11448 / 0.29787, 1e-3);
}

TEST(PaperFormulas, brighter_than_the_texture_is_counted) {
  const Image texture = filled({0.5f, 0.4f, 0.3f});
  EXPECT_EQ(ruling_of(rgb_brightness_claim(texture, texture)), Ruling::kHolds);
  const Image lit = with_first(texture, {0.6f, 0.5f, 0.4f});
  const PaperClaim claim = rgb_brightness_claim(texture, lit);
  EXPECT_EQ(ruling_of(claim), Ruling::kDoesNotHold);
  EXPECT_DOUBLE_EQ(measure(claim, "pixels brighter than the texture").value, 100.0 / 16);
}

TEST(PaperFormulas, yiq_must_be_brighter_than_the_texture_and_than_phong) {
  const Image texture = filled({0.5f, 0.4f, 0.3f}), lit = filled({0.6f, 0.5f, 0.4f});
  EXPECT_EQ(ruling_of(yiq_brightness_claim(texture, texture, lit)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(yiq_brightness_claim(texture, lit, lit)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(yiq_brightness_claim(texture, texture, texture)), Ruling::kDoesNotHold);
}

TEST(PaperFormulas, adding_grey_keeps_i_and_q_until_a_display_clamps) {
  const Image texture = filled({0.5f, 0.25f, 0.125f});
  EXPECT_EQ(ruling_of(kept_color_claim(texture, filled({0.75f, 0.5f, 0.375f}))), Ruling::kHolds);
  EXPECT_EQ(ruling_of(kept_color_claim(texture, filled({1.25f, 1.0f, 0.875f}))),
            Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(kept_color_claim(texture, filled({0.25f, 0.125f, 0.0625f}))),
            Ruling::kDoesNotHold);
}

TEST(PaperFormulas, a_highlight_is_grey_or_has_the_tint_of_what_it_adds) {
  const HighlightPictures grey{filled({0.75f, 0.5f, 0.375f}), filled({0.5f, 0.25f, 0.125f})};
  const HighlightPictures tinted{filled({0.75f, 0.25f, 0.125f}), filled({0.5f, 0.25f, 0.125f})};
  EXPECT_EQ(ruling_of(grey_added_claim(grey)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(grey_added_claim(tinted)), Ruling::kDoesNotHold);
  EXPECT_EQ(ruling_of(highlight_depends_claim(grey)), Ruling::kDoesNotHold);
  EXPECT_EQ(ruling_of(highlight_depends_claim(tinted)), Ruling::kHolds);
}

TEST(PaperFormulas, restrictions_are_eliminated_by_brightness_and_tint) {
  const HighlightPictures dark{filled({0.75f, 0.5f, 0.375f}), filled({0.5f, 0.25f, 0.125f})};
  const HighlightPictures bright{filled({1, 0.5f, 0.25f}), filled({0.75f, 0.5f, 0.375f})};
  EXPECT_EQ(ruling_of(eliminated_claim(dark, bright)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(eliminated_claim(bright, bright)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(eliminated_claim(dark, dark)), Ruling::kDoesNotHold);
}

TEST(PaperFormulas, two_textures_that_a_display_cuts_to_white_look_the_same) {
  const Image red = filled({0.6f, 0.2f, 0.1f}), blue = filled({0.1f, 0.2f, 0.6f});
  EXPECT_EQ(ruling_of(always_depends_claim(red, blue)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(always_depends_claim(with_first(red, {1.6f, 1.2f, 1.1f}),
                                           with_first(blue, {1.1f, 1.2f, 1.6f}))),
            Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(always_depends_claim(red, red)), Ruling::kDoesNotHold);
}

}  // namespace
}  // namespace lumaknot::paper
