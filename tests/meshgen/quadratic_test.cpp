#include "meshgen/quadratic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lumaknot {
namespace {

TEST(Quadratic, is_least_where_a_grid_is) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Quadratic f{any(random), any(random), any(random), any(random), any(random), any(random)};
    const double x_most = std::exp(2 * any(random)), y_most = std::exp(2 * any(random));
    const Least least = least_in_box(f, x_most, y_most);
    double sampled = f(0, 0);
    for (int x = -20; x <= 20; ++x) {
      for (int y = -20; y <= 20; ++y) {
        sampled = std::min(sampled, f(x_most * x / 20, y_most * y / 20));
      }
    }
    EXPECT_LE(std::abs(least.x), x_most);
    EXPECT_LE(std::abs(least.y), y_most);
    EXPECT_EQ(f(least.x, least.y), least.value);
    EXPECT_LE(least.value, sampled + 1e-12);  // rounding of values up to 60
    // The grid's nearest point is half a step of x_most / 20 and y_most / 20 from the least one.
    const double step = std::max(x_most, y_most) / 20;
    EXPECT_GE(least.value, sampled - step * step) << i;  // second derivatives of at most one each
  }
}

TEST(Quadratic, is_least_within_where_it_is_convex) {
  const Least least = least_in_box({3, -2, 4, 2, 0, 4}, 5, 5);  // 1 from (x - 1)^2 + 2 (y + 1)^2
  EXPECT_DOUBLE_EQ(least.x, 1);
  EXPECT_DOUBLE_EQ(least.y, -1);
  EXPECT_DOUBLE_EQ(least.value, 0);
}

}  // namespace
}  // namespace lumaknot
