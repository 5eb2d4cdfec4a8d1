// The test of noisy pictures on noise whose distribution is known.
#include "validate/compare/noise.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

#include "validate/compare/noise_words.h"
#include "validate/compare/one_sided.h"

namespace lumaknot::validate {
namespace {

constexpr int kSize = 64, kSamples = 64;

/// The noise of one pixel in one picture.
using NoiseOf = std::function<double(std::mt19937&, double spread)>;

/// As large as independent samples make it.
double normal_noise(std::mt19937& random, double spread) {
  return std::normal_distribution<double>(0, spread / std::sqrt(kSamples))(random);
}

/// A twentieth of that, like a stratified sampler's; at one pixel in fifty seven times as much.
double mixed_noise(std::mt19937& random, double spread) {
  const bool is_rare = std::uniform_int_distribution<int>(0, 49)(random) == 0;
  return normal_noise(random, spread * (is_rare ? 0.35 : 0.05));
}

/// Of few samples that all differ, as at an edge: the number of hits of a small part of a pixel.
double hit_noise(std::mt19937& random, double spread) {
  const double share = (1 - std::sqrt(std::max(0.0, 1 - 4 * spread * spread))) / 2;
  return std::binomial_distribution<int>(kSamples, share)(random) / double(kSamples) - share;
}

/// A disk with a pattern: nothing outside, edges in many sizes, smooth inside.
FilteredImage disk() {
  const Grid<Channels> blank(kSize, kSize);
  FilteredImage image{{blank, blank}, blank, blank};
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double radius = std::hypot(x + 0.5 - kSize / 2.0, y + 0.5 - kSize / 2.0);
      const double coverage = std::clamp(24.2 - radius, 0.0, 1.0);
      const double shade = coverage * (0.6 + 0.3 * std::sin(0.3 * x + 0.2 * y));
      const double edge = std::sqrt(coverage * (1 - coverage));
      const double slope = coverage > 0 ? 0.02 + 0.015 * std::sin(0.7 * y) : 0;
      const std::size_t i = std::size_t(y) * kSize + std::size_t(x);
      for (Grid<Channels>& half : image.halves) half.pixels[i] = {shade, shade, shade, coverage};
      const double spread = std::hypot(slope, edge), reach = edge > 0 ? 1.0 : 4 * slope;
      image.spread.pixels[i] = {spread, spread, spread, edge};
      image.reach.pixels[i] = {reach, reach, reach, edge > 0 ? 1.0 : 0.0};
    }
  }
  return image;
}

/// A picture of it; `change` makes its mean another.
Image noisy(const FilteredImage& expected, const NoiseOf& noise, std::mt19937& random,
            const std::function<double(int x, int y, double value)>& change = {}) {
  Image image(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      std::array<float, 4> values{};
      for (std::size_t c = 0; c < 4; ++c) {
        const double mean = expected.halves[0].at(x, y)[c];
        const double shown = change && c < 3 ? change(x, y, mean) : mean;
        values[c] = float(shown + noise(random, expected.spread.at(x, y)[c]));
      }
      image.at(x, y) = {{values[0], values[1], values[2]}, values[3]};
    }
  }
  return image;
}

NoiseTest test_of(const FilteredImage& expected, const NoiseOf& noise, std::mt19937& random,
                  double family_error, const std::function<double(int, int, double)>& change = {}) {
  const Image first = noisy(expected, noise, random, change);
  const Image second = noisy(expected, noise, random, change);
  return test_noise({first, second, expected, kSamples}, family_error);
}

bool differs(const NoiseTest& test) { return test.exceeded(false) + test.exceeded(true) > 0; }

/// How many of 100 pairs differ with a family error of 0.1, and of these with one of 0.001.
std::pair<int, int> alarms(const FilteredImage& expected, const NoiseOf& noise,
                           std::mt19937& random) {
  int often = 0, rarely = 0;
  for (int i = 0; i < 100; ++i) {
    const Image first = noisy(expected, noise, random), second = noisy(expected, noise, random);
    const NoisyPair pair{first, second, expected, kSamples};
    if (!differs(test_noise(pair, 0.1))) continue;
    ++often;
    rarely += differs(test_noise(pair, 1e-3));
  }
  return {often, rarely};
}

class NoiseTests : public ::testing::Test {
 protected:
  void expect_few_alarms(const NoiseOf& noise) {
    const auto [often, rarely] = alarms(expected_, noise, random_);
    EXPECT_LE(often, 10 + 9) << "0.1 of 100 pictures, and three standard deviations";
    EXPECT_EQ(rarely, 0) << "expected at most 0.1";
  }
  FilteredImage expected_ = disk();
  std::mt19937 random_{20260701};
};

TEST_F(NoiseTests, find_normal_noise_to_differ_no_more_often_than_stated) {
  expect_few_alarms(normal_noise);
}

TEST_F(NoiseTests, find_noise_with_heavy_tails_to_differ_no_more_often_than_stated) {
  expect_few_alarms(mixed_noise);
}

TEST_F(NoiseTests, find_rare_hits_to_differ_no_more_often_than_stated) {
  for (std::size_t i = 0; i < expected_.reach.pixels.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      if (expected_.spread.pixels[i][c] > 0) expected_.reach.pixels[i][c] = 1;
    }
  }
  expect_few_alarms(hit_noise);
}

TEST_F(NoiseTests, notice_a_gain_of_half_a_percent) {
  const auto gain = [](int, int, double value) { return 1.005 * value; };
  const NoiseTest test = test_of(expected_, mixed_noise, random_, 1e-3, gain);
  EXPECT_GT(test.exceeded(false), 0);
  EXPECT_EQ(test.exceeded(true), 0) << "coverage is as it should be";
  EXPECT_TRUE(test.scales.back().worst.exceeds()) << "the whole picture shows it";
  EXPECT_FALSE(test.scales.front().worst.exceeds()) << "no single pixel does";
  EXPECT_GT(test.scales.back().worst.bias, 0);
}

TEST_F(NoiseTests, notice_one_wrong_pixel) {
  const auto wrong = [](int x, int y, double value) {
    return x == 30 && y == 25 ? value - 0.2 : value;
  };
  const NoiseTest test = test_of(expected_, mixed_noise, random_, 1e-3, wrong);
  EXPECT_EQ(test.scales.front().exceeded, 3) << "its red, green and blue";
  EXPECT_EQ(test.scales.front().worst.place.x, 30);
  EXPECT_EQ(test.scales.front().worst.place.y, 25);
  EXPECT_NEAR(test.scales.front().worst.bias, -0.2, 0.01);
  EXPECT_EQ(test.marks.at(30, 25), 1 + PixelMark(PixelClass::kUnexplained));
  EXPECT_EQ(finding_text(test, 0).substr(0, 27), "3 pixels, most at (30, 25):");
}

TEST_F(NoiseTests, notice_a_block_that_is_a_pixel_off) {
  const auto shifted = [&](int x, int y, double value) {
    const bool is_inside = x >= 24 && x < 40 && y >= 24 && y < 40;
    return is_inside ? expected_.halves[0].at(x + 1, y)[0] : value;
  };
  EXPECT_GT(test_of(expected_, mixed_noise, random_, 1e-3, shifted).exceeded(false), 0);
}

TEST_F(NoiseTests, see_the_bias_that_they_say) {
  const double seen = test_of(expected_, mixed_noise, random_, 1e-3).scales.back().seen;
  EXPECT_GT(seen, 0);
  int noticed = 0;
  constexpr int kPictures = 40;
  for (int i = 0; i < kPictures; ++i) {
    const auto biased = [&](int, int, double value) { return value + 1.1 * seen; };
    noticed += test_of(expected_, mixed_noise, random_, 1e-3, biased).scales.back().exceeded > 0;
  }
  EXPECT_GE(noticed, 34) << "95 % of them, less three standard deviations";
}

TEST_F(NoiseTests, grant_what_our_own_sampling_errs) {
  for (std::size_t i = 0; i < expected_.halves[0].pixels.size(); ++i) {
    for (const std::size_t c : {0, 1, 2}) {
      const double error = expected_.spread.pixels[i][c] * (i % 7 < 3 ? 0.01 : -0.01);
      expected_.halves[0].pixels[i][c] += error;
      expected_.halves[1].pixels[i][c] -= error;
    }
  }
  EXPECT_FALSE(differs(test_of(expected_, mixed_noise, random_, 1e-3)));
}

TEST(BothBeyond, is_the_square_of_a_normal_tail_where_the_variance_is_known) {
  EXPECT_NEAR(both_beyond(0, 1000), 0.5, 1e-6) << "two signs of four";
  const double tail = std::erfc(3 / std::sqrt(2.0)) / 2;
  EXPECT_NEAR(both_beyond(3, 1e5) / (2 * tail * tail), 1, 1e-3);
}

TEST(BothBeyond, agrees_with_drawn_numbers) {
  std::mt19937 random(7);
  constexpr double kFreedom = 5;
  int both = 0;
  constexpr int kDraws = 400'000;
  for (int i = 0; i < kDraws; ++i) {
    const double deviation =
        std::sqrt(kFreedom / std::chi_squared_distribution<double>(kFreedom)(random));
    std::normal_distribution<double> normal(0, deviation);
    const double a = normal(random), b = normal(random);
    both += std::min(std::abs(a), std::abs(b)) > 2 && (a > 0) == (b > 0);
  }
  const double expected = kDraws * both_beyond(2, kFreedom);
  EXPECT_NEAR(both, expected, 3 * std::sqrt(expected));
}

TEST(DeviationsOf, is_the_inverse) {
  for (const double freedom : {4.1, 8.0, 512.0}) {
    for (const double chance : {0.1, 1e-5, 1e-9}) {
      EXPECT_NEAR(both_beyond(deviations_of(chance, freedom), freedom) / chance, 1, 5e-3);
    }
  }
}

TEST(BernsteinDistance, holds_for_the_rarest_hits) {
  // One sample in 10,000 hits: of 64, none does, rarely one. Both pictures must exceed it.
  const double share = 1e-4, spread = std::sqrt(share * (1 - share));
  const double distance = bernstein_distance(1e-8, spread, 1, 64);
  double below = 0, term = std::pow(1 - share, 64);  // the chance of at most `hits` hits
  for (int hits = 0; hits / 64.0 - share <= distance; ++hits) {
    below += term;
    term *= (64.0 - hits) / (hits + 1) * share / (1 - share);
  }
  EXPECT_LE(std::pow(1 - below, 2), 1e-8);
}

}  // namespace
}  // namespace lumaknot::validate
