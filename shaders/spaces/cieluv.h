/// CIE 1976 L*u*v*: CIE 15:2004, 8.2.2 (ISO/CIE 11664-5), white D65 of srgb.h.
#pragma once

#include "shaders/spaces/cielab.h"

namespace lumaknot {

/// L* 0 for black, 100 for white; u* in [-83.1, 175.1], v* in [-134.2, 107.5] for colours of the
/// RGB cube.
template <class S>
struct Luv {
  S lightness, u, v;
};

/// X + 15 Y + 3 Z, the denominator of u' and v'.
inline constexpr Vec3d kUvDenominator{1, 15, 3};

/// u', v' of white: 0.19783, 0.46832.
inline constexpr double kWhiteU = 4 * kWhiteXyz.x / dot(kUvDenominator, kWhiteXyz);
inline constexpr double kWhiteV = 9 * kWhiteXyz.y / dot(kUvDenominator, kWhiteXyz);

/// How far from white's u', v' a colour can be: the circle contains the sRGB gamut, whose farthest
/// point is blue at 0.3112, and ends above v' = 0, where X and Z would be infinite.
inline constexpr double kUvRadius = 0.32;

/// Black, which has no chromaticity, has u* = v* = 0.
template <class S>
Luv<S> luv_from_xyz(const Vec<S>& xyz) {
  const S lightness = named("lightness", lightness_of_luminance<S>(y_of(xyz)));
  const S part = named("uv_part", S(1) / max(dot(constant_vec<S>(kUvDenominator), xyz), S(1e-9)));
  const S strength = lightness * S(13);
  return {lightness, named("u_star", strength * (x_of(xyz) * part * S(4) - S(kWhiteU))),
          named("v_star", strength * (y_of(xyz) * part * S(9) - S(kWhiteV)))};
}

/// The inverse of luv_from_xyz. Where L* is too low for u*, v* to be a colour (farther from white
/// than kUvRadius) the saturation stays at that radius; so black is black whatever u*, v*.
template <class S>
Vec<S> xyz_from_luv(const Luv<S>& luv) {
  const S chroma = named("uv_chroma", sqrt(luv.u * luv.u + luv.v * luv.v));
  const S strength = max(abs(luv.lightness) * S(13), chroma * S(1 / kUvRadius));
  const S scale = named("uv_scale", S(1) / max(strength, S(1e-9)));
  const S u = named("u_prime", luv.u * scale + S(kWhiteU));
  const S v = named("v_prime", luv.v * scale + S(kWhiteV));
  const S y = named("lit_y", luminance_of_lightness(luv.lightness));
  const S part = named("lit_part", y / (v * S(4)));
  return named("lit_xyz", make_vec(u * S(9) * part, y, (S(12) - u * S(3) - v * S(20)) * part));
}

}  // namespace lumaknot
