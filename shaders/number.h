/// What a formula may ask of its number type S: + - *, and the functions below, for scalars and
/// for vectors `Vec<S>`. `double` and `float` here; the recording type in expression.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "scene/vec.h"

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

/// `x` limited to [0, 1].
template <std::floating_point S>
S saturate(S x) {
  return std::clamp(x, S(0), S(1));
}

template <std::floating_point S>
Vec3<S> saturate(const Vec3<S>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

/// `base` to the power `exponent`; base >= 0.
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

/// `x` under a name that printed code shows.
template <std::floating_point S>
S named(const char*, S x) {
  return x;
}
template <std::floating_point S>
Vec3<S> named(const char*, const Vec3<S>& v) {
  return v;
}

}  // namespace lumaknot
