// What every term says of itself, held against its formula: a new one is tested as soon as it is
// listed.
#include <gtest/gtest.h>

#include "models/registry.h"
#include "tests/shaders/formulas/random_surface.h"

namespace lumaknot {
namespace {

/// A term, the numbers that it reads, and the formula as a function of directions.
template <class T>
struct Tried {
  std::array<double, T::kParameters.size()> numbers;

  auto apply(auto f) const { return std::apply(f, numbers); }
  double value(const Vec3d& n, const Vec3d& l, const Vec3d& v) const {
    const Directions<double> d{n, l, v, dot(n, l)};
    return apply([&](const auto&... p) { return T::value(d, p...); });
  }
};

/// Calls check(tried, random) for every term with random numbers of its range, ends included.
template <class F>
void for_random_terms(F check) {
  RandomSurface random;
  for_each_term([&]<class T>(T) {
    for (int i = 0; i < 400; ++i) {
      Tried<T> tried;
      for (std::size_t k = 0; k < tried.numbers.size(); ++k) {
        const Interval<double>& range = T::kParameters[k].range;
        const double max = std::min(range.max, T::kParameters[k].slider.max);
        const double at = i % 4 == 0 ? double(i / 4 % 2) : random.number(0, 1);
        tried.numbers[k] = range.min + at * at * (max - range.min);  // more of the small ones
      }
      SCOPED_TRACE(T::kEnergySamples[0].name);
      SCOPED_TRACE(::testing::PrintToString(tried.numbers));
      check(tried, random);
    }
  });
}

/// The unit vector `angle` radians from `n`, towards a random direction.
Vec3d turned(const Vec3d& n, double angle, RandomSurface& random) {
  const Vec3d side = normalize(cross(n, random.direction()));
  return n * std::cos(angle) + side * std::sin(angle);
}

/// A rounding of the values, which are near one.
constexpr double kRounding = 1e-12;

TEST(Terms, stay_below_their_largest_value) {
  for_random_terms([]<class T>(const Tried<T>& term, RandomSurface& random) {
    const double largest = term.apply([](auto... p) { return T::largest(p...); });
    const Vec3d n = random.direction(), l = random.direction(), v = random.direction();
    EXPECT_LE(term.value(n, l, v), largest * (1 + kRounding));
    EXPECT_LE(term.value(n, n, n), largest * (1 + kRounding));
    EXPECT_GE(term.value(n, l, v), 0);
  });
}

TEST(Terms, change_no_faster_with_the_normal_than_their_slope) {
  for_random_terms([]<class T>(const Tried<T>& term, RandomSurface& random) {
    const std::optional<double> slope = term.apply([](auto... p) { return T::slope(p...); });
    if (!slope) return;
    const Vec3d n = random.direction(), l = random.direction(), v = random.direction();
    constexpr double kStep = 1e-4;
    const double change = term.value(turned(n, kStep, random), l, v) - term.value(n, l, v);
    EXPECT_LE(std::abs(change), *slope * kStep * (1 + kStep) + kRounding);
  });
}

TEST(Terms, are_interpolated_within_their_error) {
  for_random_terms([]<class T>(const Tried<T>& term, RandomSurface& random) {
    const double turn = random.number(0.01, 0.5);
    const std::optional<double> error =
        term.apply([&](auto... p) { return T::interpolation_error(turn, p...); });
    if (!error) return;
    const Vec3d a = random.direction(), b = turned(a, turn, random);
    const Vec3d l = random.direction(), v = random.direction();
    for (const double t : {0.1, 0.25, 0.5, 0.75}) {
      const Vec3d between = normalize(a * (1 - t) + b * t);
      const double interpolated = term.value(a, l, v) * (1 - t) + term.value(b, l, v) * t;
      EXPECT_LE(std::abs(term.value(between, l, v) - interpolated), *error + kRounding);
    }
  });
}

TEST(Terms, that_povray_does_not_draw_name_the_nearest_setting) {
  for_random_terms([]<class T>(const Tried<T>& term, RandomSurface&) {
    const PovTerm pov = term.apply([](auto... p) { return T::pov(p...); });
    EXPECT_EQ(pov.lack.empty(), pov.nearest.empty());
  });
}

TEST(Terms, of_energy_samples_have_numbers_in_range) {
  for_each_term([]<class T>(T) {
    for (const auto& sample : T::kEnergySamples) {
      for (std::size_t i = 0; i < sample.numbers.size(); ++i) {
        EXPECT_GE(sample.numbers[i], T::kParameters[i].range.min) << sample.name;
        EXPECT_LE(sample.numbers[i], T::kParameters[i].range.max) << sample.name;
      }
    }
  });
}

}  // namespace
}  // namespace lumaknot
