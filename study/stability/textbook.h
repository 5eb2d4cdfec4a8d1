/// Formulas as printed in textbooks, without the guards that ours have: the atlas shows them fail.
/// Nothing else may use them.
#pragma once

#include <cmath>

#include "math/angle.h"
#include "shaders/formulas/terms.h"

namespace lumaknot::stability::textbook {

/// 2^(k log2 b), as graphics hardware computes pow(b, k): not a number for 0^0.
template <class S>
S power(S b, S k) {
  return std::exp2(k * std::log2(b));
}

/// n.l (n.l n.v)^(k-1): Minnaert's diffuse term, infinite at the limb where k < 1/2.
template <class S>
S minnaert(const Directions<S>& d, S k) {
  const S lit = std::max(d.n_dot_l, S(0)), seen = std::max(dot(d.n, d.v), S(0));
  return lit * std::pow(lit * seen, k - 1);
}

/// Oren and Nayar's eq. 30 by its angles: arc cosines, tangents, and the azimuth between two
/// projections that may be zero.
template <class S>
S oren_nayar(const Directions<S>& d, S sigma) {
  const S variance = sigma * sigma, n_dot_v = dot(d.n, d.v);
  const S a = 1 - S(0.5) * variance / (variance + S(0.33));
  const S b = S(0.45) * variance / (variance + S(0.09));
  const S in = std::acos(d.n_dot_l), out = std::acos(n_dot_v);
  const Vec3<S> l_across = normalize(d.l - d.n * d.n_dot_l);
  const Vec3<S> v_across = normalize(d.v - d.n * n_dot_v);
  const S azimuth = std::max(S(0), dot(l_across, v_across));
  return std::max(d.n_dot_l, S(0)) *
         (a + b * azimuth * std::sin(std::max(in, out)) * std::tan(std::min(in, out)));
}

/// GGX: alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2).
template <class S>
S ggx(S n_dot_h, S alpha) {
  const S alpha2 = alpha * alpha;
  const S spread = n_dot_h * n_dot_h * (alpha2 - 1) + 1;
  return alpha2 / (S(kPi) * spread * spread);
}

/// pi D G F / (4 n.l n.v) n.l: Cook and Torrance's highlight with their G, GGX and F = 1, in the
/// convention of terms.h.
template <class S>
S cook_torrance(const Directions<S>& d, S roughness) {
  const Vec3<S> h = normalize(d.l + d.v);
  const S n_dot_h = dot(d.n, h), n_dot_v = dot(d.n, d.v), v_dot_h = dot(d.v, h);
  const S g = std::min({S(1), 2 * n_dot_h * n_dot_v / v_dot_h, 2 * n_dot_h * d.n_dot_l / v_dot_h});
  return S(kPi) * ggx(n_dot_h, roughness * roughness) * g / (4 * d.n_dot_l * n_dot_v) * d.n_dot_l;
}

}  // namespace lumaknot::stability::textbook
