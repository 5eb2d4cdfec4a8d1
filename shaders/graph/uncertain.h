/// Numbers that carry how uncertain they are, for the formulas in shaders/: a value in double, and
/// the variance of its error in single precision, by source.
#pragma once

#include <array>
#include <cmath>

#include "math/number.h"

namespace lumaknot {

/// Where an error comes from.
enum class ErrorSource {
  kFormula,   ///< roundings of the formula's own steps
  kPower,     ///< of pow(): kPowerUnit relative to its value, and as much per unit of the exponent
  kPosition,  ///< the surface's position, which the caller gives
  kNormal,    ///< its normal
  kTexel      ///< the texture's own numbers
};
inline constexpr std::size_t kErrorSources = 5;
inline constexpr double kPowerUnit = 0x1p-20;

/// A number with the variance of its error, first order: sources are independent, and so are the
/// roundings, each uniform up to half a unit in the last place of float32. What all channels of a
/// texture have in common, its place, is carried as slopes instead.
struct Uncertain {
  double value = 0;
  std::array<double, kErrorSources> variance{};
  std::array<double, 2> slope{};  ///< per deviation of each texture coordinate

  Uncertain() = default;
  Uncertain(double x) : value(x) { (*this)[ErrorSource::kFormula] = squared(x - double(float(x))); }
  explicit operator double() const { return value; }

  double& operator[](ErrorSource source) { return variance[std::size_t(source)]; }

  static double squared(double x) { return x * x; }

  /// `value` with the errors of a and b times these slopes, and a rounding of its own of `ulps`
  /// half units in the last place.
  static Uncertain from(double value, const Uncertain& a, double slope_a, const Uncertain& b,
                        double slope_b, double ulps = 1) {
    Uncertain result;
    result.value = value;
    for (std::size_t i = 0; i < kErrorSources; ++i) {
      result.variance[i] = squared(slope_a) * a.variance[i] + squared(slope_b) * b.variance[i];
    }
    for (std::size_t i = 0; i < 2; ++i) {
      result.slope[i] = slope_a * a.slope[i] + slope_b * b.slope[i];
    }
    result.round(ulps);
    return result;
  }
  static Uncertain from(double value, const Uncertain& a, double slope, double ulps) {
    return from(value, a, slope, {}, 0, ulps);
  }

  friend Uncertain operator+(const Uncertain& a, const Uncertain& b) {
    return from(a.value + b.value, a, 1, b, 1);
  }
  friend Uncertain operator-(const Uncertain& a, const Uncertain& b) {
    return from(a.value - b.value, a, 1, b, -1);
  }
  friend Uncertain operator*(const Uncertain& a, const Uncertain& b) {
    return from(a.value * b.value, a, b.value, b, a.value);
  }
  friend Uncertain operator/(const Uncertain& a, const Uncertain& b) {
    const double quotient = a.value / b.value;
    return from(quotient, a, 1 / b.value, b, -quotient / b.value);
  }
  friend Uncertain operator-(Uncertain a) {
    a.value = -a.value;
    a.slope = {-a.slope[0], -a.slope[1]};
    return a;
  }

 private:
  void round(double ulps) {
    constexpr double kHalfUnit = 0x1p-24;
    (*this)[ErrorSource::kFormula] += squared(ulps * kHalfUnit * value) / 3;
  }
};

/// Four standard deviations of a - b: which of them is larger may be decided otherwise.
inline double doubt(const Uncertain& a, const Uncertain& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kErrorSources; ++i) sum += a.variance[i] + b.variance[i];
  for (std::size_t i = 0; i < 2; ++i) sum += Uncertain::squared(a.slope[i] - b.slope[i]);
  return 4 * std::sqrt(sum);
}

/// `result`, as uncertain as `other` too if that may be chosen instead.
inline Uncertain chosen(Uncertain result, const Uncertain& other, bool in_doubt) {
  if (!in_doubt) return result;
  for (std::size_t i = 0; i < kErrorSources; ++i) {
    result.variance[i] = std::max(result.variance[i], other.variance[i]);
  }
  result[ErrorSource::kFormula] += Uncertain::squared(result.value - other.value);
  return result;
}

inline Uncertain max(const Uncertain& a, const Uncertain& b) {
  const bool in_doubt = std::abs(a.value - b.value) <= doubt(a, b);
  return a.value < b.value ? chosen(b, a, in_doubt) : chosen(a, b, in_doubt);
}

inline Uncertain min(const Uncertain& a, const Uncertain& b) {
  const bool in_doubt = std::abs(a.value - b.value) <= doubt(a, b);
  return b.value < a.value ? chosen(b, a, in_doubt) : chosen(a, b, in_doubt);
}

inline Uncertain abs(const Uncertain& x) { return x.value < 0 ? -x : x; }

/// Near zero an error d becomes sqrt(d) at most.
inline Uncertain sqrt(const Uncertain& x) {
  const double root = std::sqrt(x.value);
  const double floor = std::sqrt(doubt(x, {}) / 4);
  return Uncertain::from(root, x, root + floor > 0 ? 0.5 / std::max(root, floor) : 0, 1);
}

inline Uncertain exp(const Uncertain& x) {
  const double value = std::exp(x.value);
  return Uncertain::from(value, x, value, 2 + 2 * std::abs(x.value));
}

inline Uncertain log(const Uncertain& x) {
  const double value = std::log(x.value);
  Uncertain result = Uncertain::from(value, x, 1 / x.value, 2);
  result[ErrorSource::kFormula] += Uncertain::squared(0x1p-22) / 3;  // GPUs err so much near 1
  return result;
}

inline Uncertain select_less(const Uncertain& a, const Uncertain& b, const Uncertain& x,
                             const Uncertain& y) {
  const bool in_doubt = std::abs(a.value - b.value) <= doubt(a, b);
  return a.value < b.value ? chosen(x, y, in_doubt) : chosen(y, x, in_doubt);
}

inline Uncertain saturate(const Uncertain& x) { return min(max(x, Uncertain(0)), Uncertain(1)); }

inline Vec3<Uncertain> saturate(const Vec3<Uncertain>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

inline Uncertain power(const Uncertain& base, const Uncertain& exponent) {
  const double value = std::pow(base.value, exponent.value);
  if (!(base.value > 0)) return value;
  Uncertain result = Uncertain::from(value, base, exponent.value * value / base.value, exponent,
                                     value * std::log(base.value), 2);
  result[ErrorSource::kPower] +=
      Uncertain::squared(kPowerUnit * value * (1 + std::abs(exponent.value)));
  return result;
}

inline Vec3<Uncertain> unit(const Vec3<Uncertain>& v) {
  const Uncertain norm = length(v);
  return norm.value > 0 ? v / norm : v;
}

inline Vec3<Uncertain> make_vec(const Uncertain& x, const Uncertain& y, const Uncertain& z) {
  return {x, y, z};
}

inline Vec3<Uncertain> grey(const Uncertain& x) { return {x, x, x}; }

inline Vec3<Uncertain> modulate(const Vec3<Uncertain>& a, const Vec3<Uncertain>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

inline Uncertain x_of(const Vec3<Uncertain>& v) { return v.x; }
inline Uncertain y_of(const Vec3<Uncertain>& v) { return v.y; }
inline Uncertain z_of(const Vec3<Uncertain>& v) { return v.z; }

inline Uncertain named(const char*, const Uncertain& x) { return x; }
inline Vec3<Uncertain> named(const char*, const Vec3<Uncertain>& v) { return v; }

}  // namespace lumaknot
