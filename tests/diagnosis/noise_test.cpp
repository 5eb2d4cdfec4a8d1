#include "diagnosis/noise.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace lumaknot::diagnosis {
namespace {

constexpr int kSize = 64;

Drawn stripes() {
  Drawn drawn;
  for (int i = 0; i < kSize * kSize; ++i) {
    const double v = 0.5 + 0.3 * std::sin(0.9 * (i % kSize));
    drawn.colors.push_back({v, 0.5 * v, 0.2});
    drawn.coverage.push_back(1);
  }
  return drawn;
}

Target target_like(const Drawn& drawn) {
  Facts facts;
  facts.noise = 2e-4;
  return {pixel_grid(kSize, kSize, kSize * kSize), facts, drawn.colors, drawn.coverage};
}

/// `add(x, y, channel)` added to every pixel.
template <class F>
Target with(const Drawn& drawn, F add) {
  Target target = target_like(drawn);
  for (int i = 0; i < kSize * kSize; ++i) {
    Vec3d& c = target.colors[std::size_t(i)];
    const int x = i % kSize, y = i / kSize;
    c = {c.x + add(x, y, 0), c.y + add(x, y, 1), c.z + add(x, y, 2)};
  }
  return target;
}

TEST(WhiteNoise, is_measured) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.03);
  const Drawn ours = stripes();
  const auto deviation =
      white_noise(with(ours, [&](int, int, int) { return normal(random); }), ours);
  ASSERT_TRUE(deviation);
  EXPECT_NEAR(*deviation, 0.03, 1e-3);  // of 12,288 values: 0.6 %
}

TEST(WhiteNoise, is_not_what_has_a_mean) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.01, 0.03);
  const Drawn ours = stripes();
  EXPECT_FALSE(white_noise(with(ours, [&](int, int, int) { return normal(random); }), ours));
}

TEST(WhiteNoise, is_not_what_drifts) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.03);
  const Drawn ours = stripes();
  EXPECT_FALSE(white_noise(
      with(ours, [&](int x, int, int) { return normal(random) + 0.02 * std::cos(0.1 * x); }),
      ours));
}

TEST(WhiteNoise, is_not_what_neighbours_share) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.03);
  const Drawn ours = stripes();
  std::array<double, 3> last{};
  EXPECT_FALSE(white_noise(with(ours,
                                [&](int, int, int channel) {
                                  double& before = last[std::size_t(channel)];
                                  const double now = normal(random), sum = now + 0.5 * before;
                                  before = now;
                                  return sum;
                                }),
                           ours));
}

TEST(WhiteNoise, is_not_a_texture_that_is_read_otherwise) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  const Drawn ours = stripes();
  // Errors of a random sign, as large as the picture's slope.
  EXPECT_FALSE(white_noise(
      with(ours,
           [&](int x, int, int) { return 0.1 * normal(random) * std::abs(std::cos(0.9 * x)); }),
      ours));
}

TEST(WhiteNoise, is_not_rounding) {
  const Drawn ours = stripes();
  EXPECT_FALSE(white_noise(target_like(ours), ours));
}

}  // namespace
}  // namespace lumaknot::diagnosis
