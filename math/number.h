/// What a formula may require of its number type S: + - * /, and the functions below; and of a
/// vector `Vec<S>`: + -, * by a scalar, dot, cross, and the functions below. No branches on a
/// number: a choice is select_less. `double` and `float` here; the recording type in expression.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "math/vec.h"

namespace lumaknot {

template <class S>
struct VecOf {
  using type = Vec3<S>;
};

/// Three components of the number type S, as one value.
template <class S>
using Vec = typename VecOf<S>::type;

template <std::floating_point S>
S max(S a, S b) {
  return std::max(a, b);
}

template <std::floating_point S>
S min(S a, S b) {
  return std::min(a, b);
}

template <std::floating_point S>
S abs(S x) {
  return std::abs(x);
}

/// The square root of x >= 0.
template <std::floating_point S>
S sqrt(S x) {
  return std::sqrt(x);
}

/// e to the power x.
template <std::floating_point S>
S exp(S x) {
  return std::exp(x);
}

/// The natural logarithm of x > 0.
template <std::floating_point S>
S log(S x) {
  return std::log(x);
}

/// `x` where a < b, else `y`. Both are computed, so both must be finite.
template <std::floating_point S>
S select_less(S a, S b, S x, S y) {
  return a < b ? x : y;
}

/// `x` limited to [0, 1].
template <std::floating_point S>
S saturate(S x) {
  return std::clamp(x, S(0), S(1));
}

template <std::floating_point S>
Vec3<S> saturate(const Vec3<S>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

/// `base` to the power `exponent`; both >= 0, and 0 to the power 0 is 1.
template <std::floating_point S>
S power(S base, S exponent) {
  return std::pow(base, exponent);
}

/// The unit vector along `v`; zero stays zero.
template <std::floating_point S>
Vec3<S> unit(const Vec3<S>& v) {
  const S norm = length(v);
  return norm > 0 ? v / norm : v;
}

template <std::floating_point S>
Vec3<S> make_vec(S x, S y, S z) {
  return {x, y, z};
}

/// The vector whose components are all `x`.
template <std::floating_point S>
Vec3<S> grey(S x) {
  return {x, x, x};
}

/// The component-wise product.
template <std::floating_point S>
Vec3<S> modulate(const Vec3<S>& a, const Vec3<S>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <std::floating_point S>
S x_of(const Vec3<S>& v) {
  return v.x;
}
template <std::floating_point S>
S y_of(const Vec3<S>& v) {
  return v.y;
}
template <std::floating_point S>
S z_of(const Vec3<S>& v) {
  return v.z;
}

/// A vector of numbers of the formula.
template <class S>
Vec<S> constant_vec(const Vec3d& v) {
  return make_vec(S(v.x), S(v.y), S(v.z));
}

/// `x` with a name to appear in printed code.
template <std::floating_point S>
S named(const char*, S x) {
  return x;
}
template <std::floating_point S>
Vec3<S> named(const char*, const Vec3<S>& v) {
  return v;
}

}  // namespace lumaknot
