/// Numbers of the formulas in shaders/, several at once: the fast renderer's.
#pragma once

#include <limits>
#include <xsimd/xsimd.hpp>

#include "shaders/number.h"

namespace lumaknot {

/// As many floats as the instructions `A` hold. Every function of it is a template over A, so that
/// code compiled for one processor is never linked in place of another's.
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

template <class A>
Floats<A> power(const Floats<A>& base, const Floats<A>& exponent) {
  const Floats<A> least(std::numeric_limits<float>::min());
  const Floats<A> power = exp(exponent * log(max(base, least)));
  const Floats<A> of_zero = select_less(Floats<A>(0), exponent, Floats<A>(0), Floats<A>(1));
  return select_less(Floats<A>(0), base, power, of_zero);
}

/// 1 / sqrt(x) to a thousandth or better.
template <class A>
Floats<A> rough_inverse_sqrt(const Floats<A>& x) {
  return xsimd::rsqrt(x.v);
}
#ifdef __AVX512F__
// xsimd 8.1 calls an intrinsic that there never was.
inline Floats<xsimd::avx512bw> rough_inverse_sqrt(const Floats<xsimd::avx512bw>& x) {
  return Floats<xsimd::avx512bw>::Batch(_mm512_rsqrt14_ps(x.v));
}
#endif

/// 1 / sqrt(x) to 3e-7 for normal x > 0: the processor's estimate and one step of Newton's.
template <class A>
Floats<A> inverse_sqrt(const Floats<A>& x) {
  const Floats<A> y = rough_inverse_sqrt(x);
  return y * (Floats<A>(1.5) - Floats<A>(0.5) * x * y * y);
}

template <class A>
Vec3<Floats<A>> unit(const Vec3<Floats<A>>& v) {
  const Floats<A> square = dot(v, v), least(std::numeric_limits<float>::min());
  return v * select_less(least, square, inverse_sqrt(max(square, least)), Floats<A>(1));
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

}  // namespace lumaknot
