/// From encoded r'g'b' to CIE 1931 XYZ and back: sRGB, white D65.
#pragma once

#include "shaders/spaces/matrix3.h"

namespace lumaknot {

/// XYZ (Y of white: 1) from linear sRGB. Exact for the chromaticities of IEC 61966-2-1 (those of
/// Rec. ITU-R BT.709: R 0.64 0.33, G 0.30 0.60, B 0.15 0.06, D65 0.3127 0.3290); as printed in W3C
/// CSS Color Module Level 4, sample code. The standard's own matrix is this one in four digits.
inline constexpr Matrix3 kXyzFromLinear{{{506752.0 / 1228815, 87881.0 / 245763, 12673.0 / 70218},
                                         {87098.0 / 409605, 175762.0 / 245763, 12673.0 / 175545},
                                         {7918.0 / 409605, 87881.0 / 737289, 1001167.0 / 1053270}}};

inline constexpr Matrix3 kLinearFromXyz = inverse(kXyzFromLinear);

/// XYZ of white, D65: 0.95046, 1, 1.08906.
inline constexpr Vec3d kWhiteXyz{dot(kXyzFromLinear.rows[0], Vec3d{1, 1, 1}),
                                 dot(kXyzFromLinear.rows[1], Vec3d{1, 1, 1}),
                                 dot(kXyzFromLinear.rows[2], Vec3d{1, 1, 1})};

/// `magnitude` >= 0 with the sign of `x`.
template <class S>
S with_sign_of(const S& x, const S& magnitude) {
  return select_less(x, S(0), S(0) - magnitude, magnitude);
}

/// |x|^exponent with the sign of `x`; exponent > 0.
template <class S>
S odd_power(const S& x, double exponent) {
  return with_sign_of(x, power(abs(x), S(exponent)));
}

/// The same of each component.
template <class S>
Vec<S> odd_power_of(const Vec<S>& v, double exponent) {
  return make_vec(odd_power<S>(x_of(v), exponent), odd_power<S>(y_of(v), exponent),
                  odd_power<S>(z_of(v), exponent));
}

/// Linear light of one encoded channel: IEC 61966-2-1, eq. 5 and 6; odd below zero, as in CSS Color
/// 4. Its two pieces meet within 2.4e-9 (the standard's rounded constants).
template <class S>
S decode_srgb(const S& encoded) {
  const S magnitude = abs(encoded);
  const S curve = power((magnitude + S(0.055)) * S(1 / 1.055), S(2.4));
  const S decoded = select_less(S(0.04045), magnitude, curve, magnitude * S(1 / 12.92));
  return with_sign_of(encoded, decoded);
}

/// The inverse of decode_srgb: IEC 61966-2-1, eq. 9 and 10; odd below zero.
template <class S>
S encode_srgb(const S& linear) {
  const S magnitude = abs(linear);
  const S curve = power(magnitude, S(1 / 2.4)) * S(1.055) - S(0.055);
  const S encoded = select_less(S(0.0031308), magnitude, curve, magnitude * S(12.92));
  return with_sign_of(linear, encoded);
}

template <class S>
Vec<S> xyz_from_rgb(const Vec<S>& rgb) {
  const Vec<S> linear = named(
      "linear_rgb",
      make_vec(decode_srgb<S>(x_of(rgb)), decode_srgb<S>(y_of(rgb)), decode_srgb<S>(z_of(rgb))));
  return named("xyz", transform<S>(kXyzFromLinear, linear));
}

template <class S>
Vec<S> rgb_from_xyz(const Vec<S>& xyz) {
  const Vec<S> linear = named("lit_linear_rgb", transform<S>(kLinearFromXyz, xyz));
  return make_vec(encode_srgb<S>(x_of(linear)), encode_srgb<S>(y_of(linear)),
                  encode_srgb<S>(z_of(linear)));
}

}  // namespace lumaknot
