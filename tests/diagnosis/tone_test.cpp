#include "diagnosis/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lumaknot::diagnosis {
namespace {

constexpr std::array kCurves{Tone::kReinhard, Tone::kAces, Tone::kAcesFitted, Tone::kHable,
                             Tone::kNeutral,  Tone::kAgx,  Tone::kCineon};

Vec3d grey(double value) { return {value, value, value}; }

TEST(Tone, keeps_greys_grey) {
  for (const Tone tone : kCurves) {
    for (const double value : {0.02, 0.18, 0.5, 1.0, 4.0}) {
      const Vec3d c = toned(tone, grey(value));
      // The published matrices have four to six digits.
      EXPECT_NEAR(c.x, c.y, 2e-3) << int(tone);
      EXPECT_NEAR(c.x, c.z, 2e-3) << int(tone);
    }
  }
}

TEST(Tone, rises_and_stays_between_black_and_white) {
  for (const Tone tone : kCurves) {
    double before = -1e-6;
    for (double value = 0; value < 16; value += 0.05) {
      const double now = toned(tone, grey(value)).x;
      EXPECT_GE(now, before - 1e-9) << int(tone) << " at " << value;
      if (value <= 5.6) {  // Hable's white
        EXPECT_LE(now, 1 + 1e-9) << int(tone);
      }
      before = now;
    }
  }
}

TEST(Tone, has_the_values_that_are_published) {
  EXPECT_DOUBLE_EQ(toned(Tone::kReinhard, grey(1)).x, 0.5);
  EXPECT_DOUBLE_EQ(toned(Tone::kHable, grey(5.6)).x, 1);         // white, with an exposure of 2
  EXPECT_NEAR(toned(Tone::kNeutral, grey(0.5)).x, 0.46, 1e-12);  // less Fresnel's 0.04
  EXPECT_NEAR(toned(Tone::kNeutral, grey(0.76)).x, 0.72, 1e-12);
  EXPECT_NEAR(toned(Tone::kAces, grey(1)).x, 0.8037975, 1e-6);  // 2.54 / 3.16
  EXPECT_DOUBLE_EQ(toned(Tone::kCineon, grey(0.004)).x, 0);     // the film's black
}

TEST(ToneSpline, goes_through_its_points_and_is_exact_for_lines_of_the_root) {
  const ToneSpline spline{-0.5, 1};
  std::vector<double> values;
  for (int k = 0; k < 7; ++k) values.push_back(2 + 3 * (-0.5 + 1.5 * k / 6));
  for (const double root : {-0.5, -0.2, 0.0, 0.3, 0.77, 1.0}) {
    EXPECT_NEAR(spline.at(root * std::abs(root), values), 2 + 3 * root, 1e-12);
  }
  EXPECT_NEAR(spline.at(9, values), 5, 1e-12);  // constant beyond
}

TEST(ToneSpline, approaches_a_smooth_curve_as_points_come_closer) {
  const ToneSpline spline{0, 1};
  const auto error_with = [&](int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) values.push_back(std::sin(5.0 * k / (count - 1)));
    double worst = 0;
    for (double root = 0; root <= 1; root += 1e-3) {
      worst = std::max(worst, std::abs(spline.at(root * root, values) - std::sin(5 * root)));
    }
    return worst;
  };
  // At the ends, where a point is missing, the order is two.
  EXPECT_GT(error_with(11) / error_with(21), 3.5);
  EXPECT_LT(error_with(41), 2e-3);
}

}  // namespace
}  // namespace lumaknot::diagnosis
