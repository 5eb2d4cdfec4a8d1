#include "meshgen/quadratic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lumaknot {
namespace {

TEST(Quadratic, has_its_minimum_where_a_grid_does) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Quadratic f{any(random), any(random), any(random), any(random), any(random), any(random)};
    const double x_max = std::exp(2 * any(random)), y_max = std::exp(2 * any(random));
    const Minimum min = min_in_box(f, x_max, y_max);
    double sampled = f(0, 0);
    for (int x = -20; x <= 20; ++x) {
      for (int y = -20; y <= 20; ++y) {
        sampled = std::min(sampled, f(x_max * x / 20, y_max * y / 20));
      }
    }
    EXPECT_LE(std::abs(min.x), x_max);
    EXPECT_LE(std::abs(min.y), y_max);
    EXPECT_EQ(f(min.x, min.y), min.value);
    EXPECT_LE(min.value, sampled + 1e-12);  // rounding of values up to 60
    // The grid's nearest point is within half a step, x_max / 20 and y_max / 20, of the minimum.
    const double step = std::max(x_max, y_max) / 20;
    EXPECT_GE(min.value, sampled - step * step) << i;  // second derivatives are at most one
  }
}

TEST(Quadratic, has_its_minimum_inside_where_it_is_convex) {
  const Minimum min = min_in_box({3, -2, 4, 2, 0, 4}, 5, 5);  // 1 from (x - 1)^2 + 2 (y + 1)^2
  EXPECT_DOUBLE_EQ(min.x, 1);
  EXPECT_DOUBLE_EQ(min.y, -1);
  EXPECT_DOUBLE_EQ(min.value, 0);
}

}  // namespace
}  // namespace lumaknot
