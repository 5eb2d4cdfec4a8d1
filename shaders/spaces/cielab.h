/// CIE 1976 L*a*b*: CIE 15:2004, 8.2.1 (ISO/CIE 11664-4), white D65 of srgb.h.
#pragma once

#include "shaders/spaces/srgb.h"

namespace lumaknot {

/// L* 0 for black, 100 for white; a* in [-86.2, 98.3], b* in [-107.9, 94.5] for colours of the RGB
/// cube.
template <class S>
struct Lab {
  S lightness, a, b;
};

/// f(t): the cube root; below (6/29)^3, also for negative numbers, its tangent line.
template <class S>
S lab_curve(const S& t) {
  const S line = t * S(841.0 / 108) + S(4.0 / 29);
  return select_less(S(216.0 / 24389), t, power(max(t, S(0)), S(1.0 / 3)), line);
}

/// The inverse of lab_curve.
template <class S>
S inverse_lab_curve(const S& f) {
  return select_less(S(6.0 / 29), f, f * f * f, (f - S(4.0 / 29)) * S(108.0 / 841));
}

/// L* of the luminance Y (white: 1), the same in CIELAB and CIELUV.
template <class S>
S lightness_of_luminance(const S& luminance) {
  return lab_curve(luminance) * S(116) - S(16);
}

template <class S>
S luminance_of_lightness(const S& lightness) {
  return inverse_lab_curve<S>((lightness + S(16)) * S(1.0 / 116));
}

template <class S>
Lab<S> lab_from_xyz(const Vec<S>& xyz) {
  const S fx = named("fx", lab_curve<S>(x_of(xyz) * S(1 / kWhiteXyz.x)));
  const S fy = named("fy", lab_curve<S>(y_of(xyz)));
  const S fz = named("fz", lab_curve<S>(z_of(xyz) * S(1 / kWhiteXyz.z)));
  return {named("lightness", fy * S(116) - S(16)), named("a_star", (fx - fy) * S(500)),
          named("b_star", (fy - fz) * S(200))};
}

template <class S>
Vec<S> xyz_from_lab(const Lab<S>& lab) {
  const S fy = named("lit_fy", (lab.lightness + S(16)) * S(1.0 / 116));
  const S fx = named("lit_fx", fy + lab.a * S(1.0 / 500));
  const S fz = named("lit_fz", fy - lab.b * S(1.0 / 200));
  return named("lit_xyz", make_vec(inverse_lab_curve(fx) * S(kWhiteXyz.x), inverse_lab_curve(fy),
                                   inverse_lab_curve(fz) * S(kWhiteXyz.z)));
}

}  // namespace lumaknot
