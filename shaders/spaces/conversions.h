/// The spaces in which light acts on a brightness axis alone: one interface to all of them.
#pragma once

#include <cassert>

#include "scene/spec.h"
#include "shaders/spaces/atd95.h"
#include "shaders/spaces/cieluv.h"
#include "shaders/spaces/din99.h"
#include "shaders/spaces/yiq.h"
#include "shaders/spaces/yuv.h"

namespace lumaknot {

/// A colour as lighting sees it. For each space's axes see docs/spaces.
template <class S>
struct Axes {
  S brightness;  ///< 0 for black, 1 for white
  S c1, c2;      ///< chroma, in the space's own units; 0 for greys
};

/// ATD95's chroma is measured from the grey of the same A. Greys of Guth's model have T and D that
/// grow with A, so light on A alone would tint them.
template <class S>
Axes<S> axes_from_atd95(const Atd95<S>& r, const Atd95Model& m) {
  return {named("brightness", brightness_of_atd95(r.a, m)),
          named("t_chroma", r.t - r.a * S(m.white.t / m.white.a)),
          named("d_chroma", r.d - r.a * S(m.white.d / m.white.a))};
}

template <class S>
Atd95<S> atd95_from_axes(const Axes<S>& axes, const Atd95Model& m) {
  const S a = atd95_of_brightness(axes.brightness, m);
  return {a, axes.c1 + a * S(m.white.t / m.white.a), axes.c2 + a * S(m.white.d / m.white.a)};
}

template <class S>
Axes<S> axes_from_yuv(const Yuv<S>& yuv) {
  return {yuv.y, yuv.u, yuv.v};
}

template <class S>
Axes<S> axes_from_lab(const Lab<S>& lab) {
  return {named("brightness", lab.lightness * S(0.01)), lab.a, lab.b};
}

template <class S>
Axes<S> axes_from_luv(const Luv<S>& luv) {
  return {named("brightness", luv.lightness * S(0.01)), luv.u, luv.v};
}

template <class S>
Axes<S> axes_from_din99(const Din99<S>& din) {
  return {named("brightness", din.lightness * S(1 / kDin99White)), din.a, din.b};
}

/// Encoded r'g'b' in `space`, which is not kRgb. Defined for [0, 1]; finite for [-2, 2].
template <class S>
Axes<S> axes_from_rgb(const Vec<S>& rgb, Space space) {
  switch (space) {
    case Space::kYiq: {
      const Yiq<S> yiq = yiq_from_rgb<S>(rgb);
      return {yiq.y, yiq.i, yiq.q};
    }
    case Space::kYuv601:
      return axes_from_yuv(yuv_from_rgb<S>(rgb, kWeights601));
    case Space::kYuv709:
      return axes_from_yuv(yuv_from_rgb<S>(rgb, kWeights709));
    case Space::kCielab:
      return axes_from_lab(lab_from_xyz<S>(xyz_from_rgb<S>(rgb)));
    case Space::kCieluv:
      return axes_from_luv(luv_from_xyz<S>(xyz_from_rgb<S>(rgb)));
    case Space::kDin99:
      return axes_from_din99(din99_from_lab(lab_from_xyz<S>(xyz_from_rgb<S>(rgb))));
    case Space::kAtd95: {
      const Atd95Model& model = atd95_shading_model();
      return axes_from_atd95(atd95_from_xyz<S>(xyz_from_rgb<S>(rgb), model), model);
    }
    case Space::kRgb:
      break;
  }
  assert(false && "rgb has no axis of brightness");
  return {S(0), S(0), S(0)};
}

/// The inverse: encoded r'g'b', outside [0, 1] if the axes are not a colour of the cube. Finite for
/// the chroma of any colour of the cube with any brightness in [-1, 1000].
template <class S>
Vec<S> rgb_from_axes(const Axes<S>& axes, Space space) {
  const S lightness = axes.brightness * S(100);
  switch (space) {
    case Space::kYiq:
      return rgb_from_yiq(Yiq<S>{axes.brightness, axes.c1, axes.c2});
    case Space::kYuv601:
      return rgb_from_yuv(Yuv<S>{axes.brightness, axes.c1, axes.c2}, kWeights601);
    case Space::kYuv709:
      return rgb_from_yuv(Yuv<S>{axes.brightness, axes.c1, axes.c2}, kWeights709);
    case Space::kCielab:
      return rgb_from_xyz<S>(xyz_from_lab(Lab<S>{lightness, axes.c1, axes.c2}));
    case Space::kCieluv:
      return rgb_from_xyz<S>(xyz_from_luv(Luv<S>{lightness, axes.c1, axes.c2}));
    case Space::kDin99: {
      const Din99<S> din{axes.brightness * S(kDin99White), axes.c1, axes.c2};
      return rgb_from_xyz<S>(xyz_from_lab(lab_from_din99(din)));
    }
    case Space::kAtd95: {
      const Atd95Model& model = atd95_shading_model();
      return rgb_from_xyz<S>(xyz_from_atd95(atd95_from_axes(axes, model), model));
    }
    case Space::kRgb:
      break;
  }
  assert(false && "rgb has no axis of brightness");
  return grey(S(0));
}

/// The brightness of encoded r'g'b'; for a linear space just the dot product.
template <class S>
S brightness_of(const Vec<S>& rgb, Space space) {
  switch (space) {
    case Space::kYiq:
      return named("luma", dot(constant_vec<S>(kYiqFromRgb[0]), rgb));
    case Space::kYuv601:
      return named("luma", dot(constant_vec<S>(kWeights601.luma), rgb));
    case Space::kYuv709:
      return named("luma", dot(constant_vec<S>(kWeights709.luma), rgb));
    default:
      return axes_from_rgb<S>(rgb, space).brightness;
  }
}

/// The encoded value of the grey that has this brightness: one channel of rgb_from_axes of it and
/// no chroma.
template <class S>
S neutral_of(const S& brightness, Space space) {
  switch (space) {
    case Space::kCielab:
    case Space::kCieluv:
      return encode_srgb(luminance_of_lightness<S>(brightness * S(100)));
    case Space::kDin99: {
      const S lightness = lightness_of_din99<S>(brightness * S(kDin99White));
      return encode_srgb(luminance_of_lightness(lightness));
    }
    case Space::kAtd95: {
      const Atd95Model& model = atd95_shading_model();
      return encode_srgb(luminance_of_atd95_grey(atd95_of_brightness(brightness, model), model));
    }
    default:
      return brightness;
  }
}

/// The out-of-gamut rule that keeps the hue: `rgb` mixed with the grey `neutral` (encoded, of the
/// same brightness; limited to [0, 1] first) just enough that every channel is in [0, 1]. The
/// ratios of the differences from grey are kept, so r'g'b' keeps its hue angle. A colour in gamut
/// is unchanged.
template <class S>
Vec<S> reduce_chroma(const Vec<S>& rgb, const S& neutral) {
  const S g = named("neutral", saturate(neutral));
  const Vec<S> chroma = named("from_neutral", rgb - grey(g));
  const S above = named("above", S(1) / max(S(1) - g, S(1e-6)));
  const S below = named("below", S(-1) / max(g, S(1e-6)));
  const auto excess = [&](const S& c) { return max(c * above, c * below); };
  const S largest = max(max(excess(x_of(chroma)), excess(y_of(chroma))), excess(z_of(chroma)));
  const S kept = named("kept", S(1) / max(largest, S(1)));
  return saturate(grey(g) + chroma * kept);
}

}  // namespace lumaknot
