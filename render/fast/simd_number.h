/// A SIMD number type for the formulas in shaders/: the fast renderer's.
#pragma once

#include <cstdint>
#include <limits>
#include <xsimd/xsimd.hpp>

#include "math/number.h"

namespace lumaknot::fast {

/// The bits of a batch as a `Batch`; xsimd 9 and later require its element type.
template <class Batch, class T, class A>
Batch bits_as(const xsimd::batch<T, A>& x) {
#if XSIMD_VERSION_MAJOR < 9
  return xsimd::bitwise_cast<Batch>(x);
#else
  return xsimd::bitwise_cast<typename Batch::value_type>(x);
#endif
}

/// As many floats as a register of the instruction set `A` holds. Every function of it is a
/// template over A, so that code compiled for one processor is never linked in place of another's.
template <class A>
struct Floats {
  using Batch = xsimd::batch<float, A>;
  static constexpr std::size_t kWidth = Batch::size;

  Batch v;

  Floats() : v(0.0f) {}
  Floats(const Batch& batch) : v(batch) {}
  Floats(double x) : v(float(x)) {}

  static Floats load(const float* from) { return Batch::load_unaligned(from); }
  void store(float* to) const { v.store_unaligned(to); }

  friend Floats operator+(const Floats& a, const Floats& b) { return Batch(a.v + b.v); }
  friend Floats operator-(const Floats& a, const Floats& b) { return Batch(a.v - b.v); }
  friend Floats operator*(const Floats& a, const Floats& b) { return Batch(a.v * b.v); }
  friend Floats operator/(const Floats& a, const Floats& b) { return Batch(a.v / b.v); }
  friend Floats operator-(const Floats& a) { return Batch(-a.v); }
};

template <class A>
Floats<A> max(const Floats<A>& a, const Floats<A>& b) {
  return xsimd::max(a.v, b.v);
}

template <class A>
Floats<A> min(const Floats<A>& a, const Floats<A>& b) {
  return xsimd::min(a.v, b.v);
}

template <class A>
Floats<A> abs(const Floats<A>& x) {
  return xsimd::abs(x.v);
}

template <class A>
Floats<A> sqrt(const Floats<A>& x) {
  return xsimd::sqrt(x.v);
}

template <class A>
Floats<A> exp(const Floats<A>& x) {
  return xsimd::exp(x.v);
}

template <class A>
Floats<A> log(const Floats<A>& x) {
  return xsimd::log(x.v);
}

template <class A>
Floats<A> select_less(const Floats<A>& a, const Floats<A>& b, const Floats<A>& x,
                      const Floats<A>& y) {
  return xsimd::select(a.v < b.v, x.v, y.v);
}

template <class A>
Floats<A> saturate(const Floats<A>& x) {
  return min(max(x, Floats<A>(0)), Floats<A>(1));
}

template <class A>
Vec3<Floats<A>> saturate(const Vec3<Floats<A>>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

/// A polynomial by Horner's rule, highest coefficient first.
template <class A, std::size_t n>
Floats<A> polynomial(const Floats<A>& x, const double (&coefficients)[n]) {
  Floats<A> sum(coefficients[0]);
  for (std::size_t i = 1; i < n; ++i) sum = sum * x + Floats<A>(coefficients[i]);
  return sum;
}

/// The base-2 logarithm of a normal x > 0, to 2e-7 of itself or of the exponent: x is taken as m
/// 2^e with m about 1, and log2(m) / (m - 1) by the minimax polynomial of relative error 2.6e-8.
template <class A>
Floats<A> log2(const Floats<A>& x) {
  using Whole = xsimd::batch<std::int32_t, A>;
  constexpr std::int32_t kHalfRoot = 0x3f3504f3;  // of sqrt(1/2), the smallest m
  const Whole bits = bits_as<Whole>(x.v);
  const Whole exponent = (bits - Whole(kHalfRoot)) >> 23;
  const Floats<A> t =
      Floats<A>(bits_as<typename Floats<A>::Batch>(bits - (exponent << 23))) - Floats<A>(1);
  constexpr double kTerms[] = {0.1258370578289032,   -0.20726975798606873, 0.21571560204029083,
                               -0.23894481360912323, 0.28791624307632446,  -0.3607036769390106,
                               0.48091062903404236,  -0.7213473320007324,  1.4426950216293335};
  return t * polynomial(t, kTerms) + Floats<A>(xsimd::to_float(exponent));
}

/// 2 to the power x, limited to normal numbers, to 1e-7 of itself: the minimax polynomial on [-1/2,
/// 1/2] of relative error 7.5e-8.
template <class A>
Floats<A> exp2(const Floats<A>& x) {
  const Floats<A> limited = min(max(x, Floats<A>(-126)), Floats<A>(127));
  const Floats<A> whole = xsimd::nearbyint(limited.v);
  constexpr double kTerms[] = {0.0013276472454890609, 0.009675540961325169, 0.05550713092088699,
                               0.24022120237350464,   0.6931469440460205,   1.0000001192092896};
  const auto scale = (xsimd::to_int(whole.v) + 127) << 23;
  return polynomial(limited - whole, kTerms) * Floats<A>(bits_as<typename Floats<A>::Batch>(scale));
}

template <class A>
Floats<A> power(const Floats<A>& base, const Floats<A>& exponent) {
  const Floats<A> min(std::numeric_limits<float>::min());
  const Floats<A> power = exp2(exponent * log2(max(base, min)));
  const Floats<A> of_zero = select_less(Floats<A>(0), exponent, Floats<A>(0), Floats<A>(1));
  return select_less(Floats<A>(0), base, power, of_zero);
}

/// 1 / sqrt(x) to a thousandth or better.
template <class A>
Floats<A> rough_inverse_sqrt(const Floats<A>& x) {
  return xsimd::rsqrt(x.v);
}
#ifdef __AVX512F__
// xsimd 8.1 calls an intrinsic that never existed.
inline Floats<xsimd::avx512bw> rough_inverse_sqrt(const Floats<xsimd::avx512bw>& x) {
  return Floats<xsimd::avx512bw>::Batch(_mm512_rsqrt14_ps(x.v));
}
#endif

/// 1 / sqrt(x) to 3e-7 for normal x > 0: the processor's estimate and one Newton step.
template <class A>
Floats<A> inverse_sqrt(const Floats<A>& x) {
  const Floats<A> y = rough_inverse_sqrt(x);
  return y * (Floats<A>(1.5) - Floats<A>(0.5) * x * y * y);
}

template <class A>
Vec3<Floats<A>> unit(const Vec3<Floats<A>>& v) {
  const Floats<A> square = dot(v, v), min(std::numeric_limits<float>::min());
  return v * select_less(min, square, inverse_sqrt(max(square, min)), Floats<A>(1));
}

template <class A>
Vec3<Floats<A>> make_vec(const Floats<A>& x, const Floats<A>& y, const Floats<A>& z) {
  return {x, y, z};
}

template <class A>
Vec3<Floats<A>> grey(const Floats<A>& x) {
  return {x, x, x};
}

template <class A>
Vec3<Floats<A>> modulate(const Vec3<Floats<A>>& a, const Vec3<Floats<A>>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <class A>
Floats<A> x_of(const Vec3<Floats<A>>& v) {
  return v.x;
}
template <class A>
Floats<A> y_of(const Vec3<Floats<A>>& v) {
  return v.y;
}
template <class A>
Floats<A> z_of(const Vec3<Floats<A>>& v) {
  return v.z;
}

template <class A>
Floats<A> named(const char*, const Floats<A>& x) {
  return x;
}
template <class A>
Vec3<Floats<A>> named(const char*, const Vec3<Floats<A>>& v) {
  return v;
}

}  // namespace lumaknot::fast
