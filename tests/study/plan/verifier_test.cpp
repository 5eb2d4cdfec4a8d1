#include "study/plan/verifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "math/angle.h"
#include "system/error.h"
#include "tests/study/plan/testing.h"

namespace lumaknot::plan {
namespace {

constexpr double kStep = 1.0 / 255;

/// The truth as seen from `dx` pixels to the right.
Image moved_truth(const SceneSpec& spec, double dx) {
  const Scene scene{{}, made(spec).texture, spec.view};
  const exact::ExactPixels pixels(scene, knot_of(spec));
  Image image(spec.view.image.width, spec.view.image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const exact::Sample sample = pixels.sample(pixels.at(x + 0.5 + dx, y + 0.5).fragment);
      image.at(x, y) = {to_rgb(sample.color), float(sample.coverage)};
    }
  }
  return image;
}

/// The middle of the image's covered pixels that no edge is near.
RgbaPixel& inner_pixel(Image& image) {
  for (int y = 8; y < image.height - 8; ++y) {
    for (int x = 8; x < image.width - 8; ++x) {
      bool inner = true;
      for (int k = -4; k <= 4; ++k) {
        inner = inner && image.at(x + k, y).coverage == 1 && image.at(x, y + k).coverage == 1;
      }
      if (inner) return image.at(x, y);
    }
  }
  ADD_FAILURE() << "no pixel is inside";
  return image.pixels.front();
}

TEST(ToleranceChecker, the_truth_itself_meets_everything) {
  const SceneSpec spec = small_spec(48);
  const ToleranceChecker checker(made(spec), knot_of(spec), {1e-6, 0});
  const ToleranceResult result = checker.check(moved_truth(spec, 0));
  EXPECT_TRUE(result.met);
  EXPECT_LT(result.error, 1e-7);  // the truth is kept in float
  EXPECT_GT(result.covered, 100);
}

TEST(ToleranceChecker, a_picture_moved_within_the_shift_is_met_and_beyond_it_is_not) {
  const SceneSpec spec = small_spec(48);
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0.25});
  EXPECT_TRUE(checker.check(moved_truth(spec, 0.24)).met);
  EXPECT_GT(checker.check(moved_truth(spec, 0.24)).shifted, 0);
  EXPECT_FALSE(checker.check(moved_truth(spec, 0.5)).met);
}

TEST(ToleranceChecker, without_a_shift_no_moved_edge_is_met) {
  const SceneSpec spec = small_spec(48);
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0});
  const ToleranceResult result = checker.check(moved_truth(spec, 0.1));
  EXPECT_FALSE(result.met);
  EXPECT_EQ(result.error, result.in_place);
}

TEST(ToleranceChecker, one_pixel_beyond_is_enough) {
  const SceneSpec spec = small_spec(48);
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0.25});
  Image image = moved_truth(spec, 0);
  RgbaPixel& pixel = inner_pixel(image);
  const RgbaPixel right = pixel;
  pixel.color.g += 0.2f;
  EXPECT_EQ(checker.check(image).failing, 1);
  pixel = right;
  pixel.coverage = 0;
  EXPECT_EQ(checker.check(image).failing, 1);
  pixel = right;
  pixel.color.r = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(checker.check(image).met);
}

TEST(ToleranceChecker, errors_in_place_are_reported_whatever_the_shift_allows) {
  const SceneSpec spec = small_spec(48);
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0.25});
  const PixelErrors moved = checker.check_all(moved_truth(spec, 0.24));
  EXPECT_TRUE(moved.total.met);
  const auto& pixels = moved.in_place.pixels;
  EXPECT_FLOAT_EQ(float(moved.total.in_place), *std::ranges::max_element(pixels));
  EXPECT_NEAR(moved.total.mean_in_place * double(moved.total.covered),
              std::accumulate(pixels.begin(), pixels.end(), 0.0), 1e-4);  // kept in float
  EXPECT_EQ(moved.total.shifted, std::ranges::count_if(pixels, [](float e) { return e > kStep; }));
}

TEST(ToleranceChecker, a_share_in_place_is_met_by_as_many_pixels_and_missed_by_one_fewer) {
  const SceneSpec spec = small_spec(48);
  const Image moved = moved_truth(spec, 0.24);
  const auto check = [&](double share) {
    return ToleranceChecker(made(spec), knot_of(spec), {kStep, 0.25, share}).check(moved);
  };
  const ToleranceResult loose = check(0);
  const double share = loose.share(loose.met_in_place());
  ASSERT_GT(share, 0);
  ASSERT_LT(share, 1);
  EXPECT_TRUE(check(share).met);
  EXPECT_EQ(check(share).lacking, 0);
  const ToleranceResult one_more = check(loose.share(loose.met_in_place() + 1));
  EXPECT_FALSE(one_more.met);
  EXPECT_EQ(one_more.lacking, 1);
  EXPECT_EQ(check(1).lacking, loose.shifted);
}

TEST(ToleranceChecker, colours_beyond_one_are_white_as_on_a_display) {
  SceneSpec spec = small_spec(48);
  spec.view.ambient = 3;
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0});
  Image image = moved_truth(spec, 0);
  EXPECT_GT(inner_pixel(image).color.r, 1.5);
  for (RgbaPixel& p : image.pixels) p.color.r = std::min(p.color.r, 1.0f);
  EXPECT_TRUE(checker.check(image).met);
}

TEST(ToleranceChecker, of_several_samples_the_mean_is_the_truth_and_sixteen_come_near) {
  SceneSpec spec = small_spec(20);
  spec.view.image.samples = 2;
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0.25});
  EXPECT_TRUE(checker.check(checker.truth()).met);
  Scene fine = made(spec);
  KnotSpec knot = knot_of(spec);
  knot.segments = 600, knot.sides = 60;
  fine.mesh = knot_mesh(knot);
  const measure::Method method{600,
                               60,
                               ShadingFrequency::kPixel,
                               Space::kRgb,
                               measure::Formula::kMatrices,
                               measure::Number::kFloat,
                               Filter::kBilinear,
                               16};
  EXPECT_TRUE(checker.check(measure::MethodRenderer(method, fine).image()).met);
  EXPECT_FALSE(checker.check(moved_truth(spec, 0.75)).met);
}

TEST(ToleranceChecker, what_less_than_the_shift_hides_counts_and_is_reported_separately) {
  // Bricks just beyond the horizon of the tube, which a coarse mesh shows.
  SceneSpec spec = small_spec(200);
  spec.texture = Bricks{};
  spec.mesh = KnotSpec{.segments = 200, .sides = 24, .repeat_u = 12, .unwrap = Unwrap::kParameter};
  const ToleranceChecker checker(made(spec), knot_of(spec), {kStep, 0.25});
  const measure::Method method{200,
                               24,
                               ShadingFrequency::kPixel,
                               Space::kRgb,
                               measure::Formula::kMatrices,
                               measure::Number::kFloat,
                               Filter::kBilinear,
                               1};
  const ToleranceResult result = checker.check(measure::MethodRenderer(method, made(spec)).image());
  EXPECT_TRUE(result.met);
  EXPECT_GT(result.hidden, 0);
  EXPECT_LT(result.hidden, result.shifted / 500);
}

/// The smallest distance from the pixel's centre at which one of many rays shows nothing.
double distance_to_nothing(const exact::ExactPixels& pixels, int x, int y, double max) {
  constexpr int kRadii = 12, kAngles = 32;
  for (int i = 1; i <= kRadii; ++i) {
    for (int k = 0; k < kAngles; ++k) {
      const double r = max * i / kRadii, a = kTurn * k / kAngles;
      const double u = x + 0.5 + r * std::cos(a), v = y + 0.5 + r * std::sin(a);
      if (!pixels.at(u, v).fragment.covered()) return r;
    }
  }
  return std::numeric_limits<double>::infinity();
}

TEST(ToleranceChecker, what_is_hidden_shares_the_shift_with_its_place) {
  const SceneSpec spec = small_spec(40);
  const Scene scene = made(spec);
  const exact::ExactPixels pixels(scene, knot_of(spec));
  const ToleranceChecker checker(scene, knot_of(spec), {kStep, 0.25});
  Image near = moved_truth(spec, 0), far = near;
  long long farther = 0, nearer = 0;
  for (int y = 0; y < near.height; ++y) {
    for (int x = 0; x < near.width; ++x) {
      if (near.at(x, y).coverage == 0) continue;
      const double distance = distance_to_nothing(pixels, x, y, 0.48);
      // Found at most a step of 0.04 too far.
      if (distance < 0.24) near.at(x, y) = {}, ++nearer;
      if (distance > 0.30 && distance <= 0.48) far.at(x, y) = {}, ++farther;
    }
  }
  EXPECT_TRUE(checker.check(near).met);
  EXPECT_GT(nearer, 20);
  EXPECT_EQ(checker.check_all(far).total.failing, farther);
  EXPECT_GT(farther, 20);
}

TEST(Passage, is_as_deep_as_the_tube_s_radius_less_the_distance_from_its_middle) {
  // A tube about the x axis, and ways at a slant that pass it at the height `away`.
  constexpr double kRadius = 0.3;
  for (const double away : {0.0, 0.01, 0.15, 0.29, 0.2999}) {
    for (const double slant : {0.0, 0.5, 3.0}) {
      const double half = std::sqrt(kRadius * kRadius - away * away);
      const Vec3d in{-half * slant, -half, away}, out = -1.0 * Vec3d{in.x, in.y, -in.z};
      const Vec3d normal = Vec3d{0, in.y, in.z} / kRadius;
      // Near the middle the square root takes half of the digits.
      EXPECT_NEAR(passage_depth(out - in, normal, kRadius), kRadius - away, 1e-8);
    }
  }
}

TEST(ToleranceChecker, refuses_a_scene_that_covers_no_pixel) {
  SceneSpec spec = small_spec(16);
  spec.view.camera.target = {0, -9, 9};
  EXPECT_THROW(ToleranceChecker(made(spec), knot_of(spec), {}), Error);
}

TEST(Tolerance, that_no_picture_can_be_held_to_is_refused) {
  for (const double color : {0.0, -1.0, 1e-8, 1.0, 5.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(check_tolerance({color, 0.25}, false), Error);
  }
  EXPECT_THROW(check_tolerance({5e-5, 0.25}, true), Error);
  EXPECT_NO_THROW(check_tolerance({5e-5, 0.25}, false));
  EXPECT_THROW(check_tolerance({0.1, -0.1}, false), Error);
  EXPECT_THROW(check_tolerance({0.1, std::numeric_limits<double>::infinity()}, false), Error);
}

}  // namespace
}  // namespace lumaknot::plan
