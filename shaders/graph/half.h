/// Numbers of half precision, IEEE 754's binary16, for the formulas in shaders/: the lowest
/// precision that `mediump` allows hardware to use.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "math/number.h"

namespace lumaknot {

/// `x` rounded to binary16, ties to even: 11 bits down to 2^-14, multiples of 2^-24 below,
/// infinity from 65520 on.
constexpr double round_to_half(double x) {
  if (!(x > -65520 && x < 65520)) {
    return x > 0 ? std::numeric_limits<double>::infinity()
                 : (x < 0 ? -std::numeric_limits<double>::infinity() : x);
  }
  constexpr double kMinNormal = 0x1p-14, kMultiples = 0x1.8p28;  // whose last place is 2^-24
  if (x > -kMinNormal && x < kMinNormal) {
    const double rounded = (x + kMultiples) - kMultiples;
    return rounded == 0 ? x * 0 : rounded;  // with the sign of x
  }
  constexpr int kDropped = 42;  // of a double's 52 bits
  std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  bits += (std::uint64_t{1} << (kDropped - 1)) - 1 + ((bits >> kDropped) & 1);
  return std::bit_cast<double>(bits >> kDropped << kDropped);
}

/// A number of half precision. Each operation is computed in double and rounded once, which equals
/// binary16 arithmetic: 53 bits are at least twice 11 plus two (S. Figueroa, "When is double
/// rounding innocuous?", 1995). Subnormal numbers, which hardware may flush to zero, are kept.
struct Half {
  float value = 0;  ///< a binary16 number

  constexpr Half() = default;
  constexpr Half(double x) : value(float(round_to_half(x))) {}
  constexpr explicit operator double() const { return value; }

  friend constexpr Half operator+(Half a, Half b) { return double(a.value) + double(b.value); }
  friend constexpr Half operator-(Half a, Half b) { return double(a.value) - double(b.value); }
  friend constexpr Half operator*(Half a, Half b) { return double(a.value) * double(b.value); }
  friend constexpr Half operator/(Half a, Half b) { return double(a.value) / double(b.value); }
  friend constexpr Half operator-(Half a) { return -double(a.value); }
  friend constexpr bool operator==(Half a, Half b) = default;
};

inline Half max(Half a, Half b) { return a.value < b.value ? b : a; }

inline Half min(Half a, Half b) { return b.value < a.value ? b : a; }

inline Half abs(Half x) { return std::abs(double(x.value)); }

inline Half sqrt(Half x) { return std::sqrt(double(x.value)); }

inline Half exp(Half x) { return std::exp(double(x.value)); }

inline Half log(Half x) { return std::log(double(x.value)); }

inline Half select_less(Half a, Half b, Half x, Half y) { return a.value < b.value ? x : y; }

inline Half saturate(Half x) { return min(max(x, Half(0)), Half(1)); }

inline Vec3<Half> saturate(const Vec3<Half>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

/// 2^(exponent log2 base), each of the three operations rounded, as GLSL ES defines pow.
inline Half power(Half base, Half exponent) {
  if (base == Half(0)) return exponent == Half(0) ? 1 : 0;
  const Half logarithm = std::log2(double(base.value));
  return std::exp2(double((exponent * logarithm).value));
}

inline Vec3<Half> unit(const Vec3<Half>& v) {
  const Half norm = length(v);
  return norm.value > 0 ? v / norm : v;
}

inline Vec3<Half> make_vec(Half x, Half y, Half z) { return {x, y, z}; }

inline Vec3<Half> grey(Half x) { return {x, x, x}; }

inline Vec3<Half> modulate(const Vec3<Half>& a, const Vec3<Half>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

inline Half x_of(const Vec3<Half>& v) { return v.x; }
inline Half y_of(const Vec3<Half>& v) { return v.y; }
inline Half z_of(const Vec3<Half>& v) { return v.z; }

inline Half named(const char*, Half x) { return x; }
inline Vec3<Half> named(const char*, const Vec3<Half>& v) { return v; }

}  // namespace lumaknot
