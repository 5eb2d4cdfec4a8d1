// Logarithms and powers of packets, against double.
#include "render/fast/simd_number.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace lumaknot::fast {
namespace {

using S = Floats<xsimd::default_arch>;
using Lanes = std::array<float, S::kWidth>;

float first(const S& x) {
  Lanes lanes;
  x.store(lanes.data());
  return lanes[0];
}

TEST(SimdNumber, log2_is_exact_to_its_last_bits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-126, 127);
  for (int i = 0; i < 100000; ++i) {
    const auto x = float(std::exp2(i % 2 ? exponent(random) : exponent(random) / 1e3));
    const double exact = std::log2(double(x));
    // Half a unit in the last place of the sum, and four of the polynomial's roundings.
    EXPECT_NEAR(first(log2(S(double(x)))), exact, std::abs(exact) * 2.5e-7) << x;
  }
}

TEST(SimdNumber, exp2_is_exact_to_its_last_bits) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> exponent(-126, 127);
  for (int i = 0; i < 100000; ++i) {
    const float x = exponent(random);
    const double exact = std::exp2(double(x));
    EXPECT_NEAR(first(exp2(S(double(x)))), exact, exact * 2.5e-7) << x;  // two units, as floats are
  }
}

// The requirements of highlights: 0 and 1 exact, and powers beyond the range of floats limited.
TEST(SimdNumber, power_of_zero_and_one_is_exact) {
  for (const double k : {0.5, 1.0, 55.0, 1e6}) {
    EXPECT_EQ(first(power(S(0), S(k))), 0);
    EXPECT_NEAR(first(power(S(1), S(k))), 1, 1.2e-7);  // the polynomial's, a unit
  }
  EXPECT_EQ(first(power(S(0), S(0))), 1);
  EXPECT_LT(first(power(S(0.5), S(1e6))), 1e-37f);
  EXPECT_TRUE(std::isfinite(first(power(S(1e30), S(100)))));
}

TEST(SimdNumber, power_errs_by_what_rounding_the_exponent_costs) {
  for (const double k : {1.0, 5.0, 55.0, 1000.0}) {
    for (int i = 1; i <= 1000; ++i) {
      const double base = double(float(i)) / 1000, exact = std::pow(double(float(base)), k);
      if (exact < 1e-37) continue;
      const double bits = std::abs(k * std::log2(base));  // its logarithm's units in the last place
      EXPECT_NEAR(first(power(S(base), S(k))), exact, exact * (3e-7 + bits * 2.5e-7)) << base;
    }
  }
}

}  // namespace
}  // namespace lumaknot::fast
