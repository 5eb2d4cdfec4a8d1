#include "shaders/graph/uncertain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/languages/every_shot.h"

namespace lumaknot {
namespace {

/// Without pow()'s own error, which is a renderer's to state.
double deviation(const Uncertain& x) {
  double sum = 0;
  for (const double part : x.variance) sum += part;
  return std::sqrt(sum - x.variance[std::size_t(ErrorSource::kPower)]);
}

/// A number whose error of 1 is the normal's.
Uncertain erring(double value) {
  Uncertain x = value;
  x[ErrorSource::kNormal] = 1;
  return x;
}

TEST(Uncertain, carries_errors_along_each_functions_slope) {
  const auto normal_error = [](const Uncertain& x) {
    return std::sqrt(x.variance[std::size_t(ErrorSource::kNormal)]);
  };
  const Uncertain x = erring(4), two = 2.0;
  EXPECT_DOUBLE_EQ(normal_error(x + two), 1);
  EXPECT_DOUBLE_EQ(normal_error(x * two), 2);
  EXPECT_DOUBLE_EQ(normal_error(two / x), 2.0 / 16);
  EXPECT_DOUBLE_EQ(normal_error(exp(x)), std::exp(4.0));
  EXPECT_DOUBLE_EQ(normal_error(log(x)), 0.25);
  EXPECT_DOUBLE_EQ(normal_error(power(x, two)), 8);
  EXPECT_DOUBLE_EQ(normal_error(sqrt(erring(1e6))), 0.5e-3);
  EXPECT_DOUBLE_EQ(normal_error(x + erring(1)), std::sqrt(2.0)) << "independent";
}

TEST(Uncertain, carries_a_common_cause_with_its_sign) {
  Uncertain x = 3, y = 5;
  x.slope = {1, 0};
  y.slope = {2, -1};
  const auto expect_slopes = [](const Uncertain& found, double u, double v) {
    EXPECT_DOUBLE_EQ(found.slope[0], u);
    EXPECT_DOUBLE_EQ(found.slope[1], v);
  };
  expect_slopes(x - y, -1, 1);
  expect_slopes(-y, -2, 1);
  expect_slopes(x * y, 11, -3);
  expect_slopes(x / y, (1 * 5.0 - 3 * 2) / 25, 3.0 / 25);
  expect_slopes(x / x, 0, 0);
  expect_slopes(max(x, y), 2, -1);
}

TEST(Uncertain, knows_the_other_choice_only_where_it_is_near) {
  const Uncertain zero = 0.0;
  EXPECT_EQ(deviation(max(Uncertain(-1.0), zero)), 0);
  EXPECT_GT(deviation(max(erring(-0.5), zero)), 0.5);
  EXPECT_EQ(saturate(Uncertain(7.0)).value, 1);
  EXPECT_GE(deviation(select_less(erring(0.5), zero, Uncertain(3.0), Uncertain(5.0))), 2);
}

/// The values of every formula in float32 differ from those in double about as much as predicted.
TEST(Uncertain, predicts_the_errors_of_every_formula_in_float32) {
  std::vector<double> largest;
  for (const Shot& shot : every_shot()) {
    RandomSurface random;
    std::vector<double> ratios;
    for (int i = 0; i < 400; ++i) {
      const View view = random.view();
      const SurfacePoint<double> point = random.point();
      const Vec3d texture = random.texture();
      const auto color = [&]<class S>(S) {
        const SurfacePoint<S> rounded{constant_vec<S>(point.position),
                                      constant_vec<S>(point.normal)};
        return stage_color<S>(rounded, constant_vec<S>(texture),
                              lighting_of<S>(view, shot.material), shot);
      };
      const Vec3d exact = color(0.0);
      const Vec3<float> single = color(0.0f);
      const Vec3<Uncertain> predicted = color(Uncertain(0.0));
      const double error = std::max({std::abs(single.x - exact.x), std::abs(single.y - exact.y),
                                     std::abs(single.z - exact.z)});
      const double expected =
          std::max({deviation(predicted.x), deviation(predicted.y), deviation(predicted.z), 1e-12});
      ratios.push_back(error / expected);
    }
    std::ranges::sort(ratios);
    // Of three numbers with one deviation, the largest is within 4.2 of them at 396 of 400;
    // dependent errors may add up.
    EXPECT_LT(ratios[395], 6) << shot.name;
    largest.push_back(ratios[395]);
  }
  // They may also cancel, as they do on the way to a perceptual space and back.
  std::ranges::sort(largest);
  EXPECT_GT(largest[largest.size() / 2], 0.3) << "predictions far from what is seen";
}

}  // namespace
}  // namespace lumaknot
