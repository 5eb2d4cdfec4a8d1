/// The YUV spaces of television: luma, and the two scaled colour differences. On encoded r'g'b'.
///
/// Luma weights: Rec. ITU-R BT.601-7, 2.5.1, and BT.709-6, 3.2. Scales: for BT.601 those of
/// analogue PAL and NTSC, U in [-0.436, 0.436] and V in [-0.615, 0.615] (BT.470-6, Table 2, rounded
/// there to U = 0.493 (B'-Y'), V = 0.877 (R'-Y')); for BT.709, which has no analogue U and V, its
/// own C_B and C_R, both in [-0.5, 0.5] (BT.709-6, 3.3).
#pragma once

#include "math/number.h"

namespace lumaknot {

/// The constants that distinguish one YUV from another.
struct YuvWeights {
  Vec3d luma;           ///< of r', g', b'; their sum is 1
  double u_max, v_max;  ///< U of full blue, V of full red
};

inline constexpr YuvWeights kWeights601{{0.299, 0.587, 0.114}, 0.436, 0.615};
inline constexpr YuvWeights kWeights709{{0.2126, 0.7152, 0.0722}, 0.5, 0.5};

/// U = this (B' - Y').
constexpr double u_scale(const YuvWeights& w) { return w.u_max / (1 - w.luma.z); }
/// V = this (R' - Y').
constexpr double v_scale(const YuvWeights& w) { return w.v_max / (1 - w.luma.x); }

/// Y in [0, 1] for colours of the RGB cube; U and V up to u_max and v_max.
template <class S>
struct Yuv {
  S y, u, v;
};

template <class S>
Yuv<S> yuv_from_rgb(const Vec<S>& rgb, const YuvWeights& w) {
  const S y = named("luma", dot(constant_vec<S>(w.luma), rgb));
  return {y, named("chroma_u", (z_of(rgb) - y) * S(u_scale(w))),
          named("chroma_v", (x_of(rgb) - y) * S(v_scale(w)))};
}

/// Y + V (1 / v_scale, -luma.x / luma.y / v_scale, 0) + U (0, -luma.z / luma.y / u_scale, 1 /
/// u_scale): the exact inverse.
template <class S>
Vec<S> rgb_from_yuv(const Yuv<S>& yuv, const YuvWeights& w) {
  const Vec3d from_u = Vec3d{0, -w.luma.z / w.luma.y, 1} / u_scale(w);
  const Vec3d from_v = Vec3d{1, -w.luma.x / w.luma.y, 0} / v_scale(w);
  return grey(yuv.y) + constant_vec<S>(from_u) * yuv.u + constant_vec<S>(from_v) * yuv.v;
}

}  // namespace lumaknot
