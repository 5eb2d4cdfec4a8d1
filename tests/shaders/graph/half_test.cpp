#include "shaders/graph/half.h"

#include <gtest/gtest.h>

#include <random>

#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/languages/every_shot.h"

namespace lumaknot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The number that a binary16's bits are: IEEE 754-2008, 3.4.
double number_of(unsigned bits) {
  const double sign = bits >> 15 ? -1 : 1;
  const int exponent = int(bits >> 10 & 31), fraction = int(bits & 1023);
  if (exponent == 31) return fraction ? std::nan("") : sign * kInfinity;
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(1024 + fraction, exponent - 25);
}

constexpr unsigned kLargest = 0x7bff, kInfinityBits = 0x7c00;

TEST(Half, every_number_of_16_bits_stays_itself) {
  for (unsigned bits = 0; bits <= kInfinityBits; ++bits) {
    for (const double x : {number_of(bits), -number_of(bits)}) {
      ASSERT_EQ(double(Half(x).value), x);
      ASSERT_EQ(std::signbit(Half(x).value), std::signbit(x));
    }
  }
  EXPECT_TRUE(std::isnan(Half(std::nan("")).value));
}

TEST(Half, what_lies_between_two_numbers_becomes_the_nearer_and_half_way_the_even_one) {
  for (unsigned bits = 0; bits < kLargest; ++bits) {
    const double low = number_of(bits), high = number_of(bits + 1), middle = (low + high) / 2;
    ASSERT_EQ(double(Half(middle).value), bits % 2 ? high : low) << low;
    ASSERT_EQ(double(Half(std::nextafter(middle, 0)).value), low);
    ASSERT_EQ(double(Half(-std::nextafter(middle, kInfinity)).value), -high);
  }
}

TEST(Half, ends_at_65504_and_at_the_24th_power_of_a_half) {
  EXPECT_EQ(Half(65519.99).value, 65504);
  EXPECT_EQ(double(Half(65520).value), kInfinity);
  EXPECT_EQ(double((Half(-256) * Half(256)).value), -kInfinity);
  EXPECT_EQ(Half(0x1p-25).value, 0);  // half way, to the even
  EXPECT_EQ(Half(0x1.01p-25).value, 0x1p-24);
}

/// The binary16 number nearest to x, found by bisection among all of them; ties to even.
double nearest(long double x) {
  unsigned low = 0, high = kInfinityBits;
  const long double size = std::abs(x);
  const auto value = [](unsigned b) { return b == kInfinityBits ? 65536 : number_of(b); };
  while (high - low > 1) {
    const unsigned middle = (low + high) / 2;
    (value(middle) <= size ? low : high) = middle;
  }
  const long double below = size - value(low), above = value(high) - size;
  const bool up = above < below || (above == below && low % 2);
  const double found = number_of(up ? high : low);
  return x < 0 ? -found : found;
}

/// Random bits: numbers of all sizes.
class RandomHalves {
 public:
  double operator()() {
    const unsigned size = unsigned(generator_() % kInfinityBits);
    return number_of(size | unsigned(generator_() % 2) << 15);
  }

 private:
  std::mt19937 generator_{20260101};
};

TEST(Half, the_four_operations_and_the_root_round_as_ieee_says) {
  RandomHalves random;
  for (int i = 0; i < 100000; ++i) {
    const double a = random(), b = random();
    // 64 bits hold a sum and a product of two halves exactly; no quotient is too close to halfway
    // to decide.
    using Long = long double;
    ASSERT_EQ(double((Half(a) + Half(b)).value), nearest(Long(a) + Long(b))) << a << " " << b;
    ASSERT_EQ(double((Half(a) - Half(b)).value), nearest(Long(a) - Long(b))) << a << " " << b;
    ASSERT_EQ(double((Half(a) * Half(b)).value), nearest(Long(a) * Long(b))) << a << " " << b;
    if (b != 0) {
      ASSERT_EQ(double((Half(a) / Half(b)).value), nearest(Long(a) / Long(b))) << a << " " << b;
    }
    const double c = std::abs(a);
    ASSERT_EQ(double(sqrt(Half(c)).value), nearest(std::sqrt(Long(c)))) << c;
  }
}

TEST(Half, exponentials_and_logarithms_are_rounded_once) {
  RandomHalves random;
  for (int i = 0; i < 20000; ++i) {
    const double a = random();
    if (std::abs(a) < 11) {
      ASSERT_EQ(double(exp(Half(a)).value), nearest(std::exp((long double)(a)))) << a;
    }
    if (a > 0) {
      ASSERT_EQ(double(log(Half(a)).value), nearest(std::log((long double)(a)))) << a;
    }
  }
}

TEST(Half, powers_err_as_the_rounded_exponent_does) {
  EXPECT_EQ(power(Half(0), Half(0)).value, 1);
  EXPECT_EQ(power(Half(0), Half(55)).value, 0);
  EXPECT_EQ(power(Half(2), Half(-3)).value, 0.125);
  // log2(0.95) = -0.07400 is kept to 2^-15, its half spacing; times 55 and once more rounded, to
  // 2^-10, that is 0.0027 of the exponent of 2.
  const double error =
      double(power(Half(0.95), Half(55)).value) / std::pow(double(Half(0.95).value), 55) - 1;
  EXPECT_LT(std::abs(error), 0.0027 * std::log(2) + 0x1p-11);
  EXPECT_GT(std::abs(error), 0);
}

TEST(Half, every_formula_can_be_computed_with_it_and_most_are_near) {
  RandomSurface random;
  std::vector<double> errors;
  for (const Shot& shot : final_shots()) {
    const View view = random.view();
    const SurfacePoint<double> p = random.point();
    const Vec3d texture = texture_value(random.texture(), shot.material);
    const Vec3<Half> color = stage_color<Half>(
        {constant_vec<Half>(p.position), constant_vec<Half>(p.normal)}, constant_vec<Half>(texture),
        lighting_of<Half>(view, shot.material), shot);
    const Vec3d exact =
        stage_color<double>(p, texture, lighting_of<double>(view, shot.material), shot);
    for (std::size_t i = 0; i < 3; ++i) {
      errors.push_back(std::abs(double(components(color)[i].value) - components(exact)[i]));
    }
  }
  std::ranges::sort(errors);
  // About twenty roundings of 2^-11 each.
  EXPECT_LT(errors[errors.size() / 2], 20 * 0x1p-11);
  EXPECT_GT(errors[errors.size() / 2], 0x1p-14);
}

}  // namespace
}  // namespace lumaknot
