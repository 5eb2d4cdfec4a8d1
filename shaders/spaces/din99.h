/// DIN99: DIN 6176:2001-03 with k_E = k_CH = 1, on CIELAB with white D65.
#pragma once

#include "shaders/spaces/cielab.h"

namespace lumaknot {

/// L99 0 for black, 100.0013 for white; a99 in [-27.5, 36.2], b99 in [-33.4, 31.2] for the
/// colours of the RGB cube.
template <class S>
struct Din99 {
  S lightness, a, b;
};

inline constexpr double kDin99LightnessScale = 105.51, kDin99LightnessBend = 0.0158;
inline constexpr double kDin99ChromaBend = 0.045, kDin99Squeeze = 0.7;
inline constexpr double kDin99Cos = 0.9612616959383189, kDin99Sin = 0.27563735581699916;  // 16 deg
/// L99 of white: 105.51 ln(1 + 0.0158 * 100).
inline constexpr double kDin99White = kDin99LightnessScale * 0.9477893989335261;

/// L99 = 105.51 ln(1 + 0.0158 L*); held at its value for L* = -63.2 below that.
template <class S>
S din99_lightness(const S& lightness) {
  return log(max(lightness * S(kDin99LightnessBend) + S(1), S(1e-3))) * S(kDin99LightnessScale);
}

/// The inverse of din99_lightness up to white; above it the tangent, since XYZ of the
/// exponential leaves the range of float at brightness 32.
template <class S>
S lightness_of_din99(const S& lightness99) {
  const S inside = min(lightness99, S(kDin99White));
  const S growth = named("growth", exp(inside * S(1 / kDin99LightnessScale)));
  const S line = (lightness99 - inside) * S(1 / kDin99LightnessScale) + S(1);
  return (growth * line - S(1)) * S(1 / kDin99LightnessBend);
}

template <class S>
Din99<S> din99_from_lab(const Lab<S>& lab) {
  const S e = named("e_axis", lab.a * S(kDin99Cos) + lab.b * S(kDin99Sin));
  const S f = named("f_axis", (lab.b * S(kDin99Cos) - lab.a * S(kDin99Sin)) * S(kDin99Squeeze));
  const S g = named("ef_chroma", sqrt(e * e + f * f));
  const S chroma = log(g * S(kDin99ChromaBend) + S(1)) * S(1 / kDin99ChromaBend);
  const S scale = named("chroma_scale", chroma / max(g, S(1e-6)));
  return {named("lightness99", din99_lightness(lab.lightness)), named("a99", e * scale),
          named("b99", f * scale)};
}

template <class S>
Lab<S> lab_from_din99(const Din99<S>& din) {
  const S chroma = named("chroma99", sqrt(din.a * din.a + din.b * din.b));
  const S g = (exp(chroma * S(kDin99ChromaBend)) - S(1)) * S(1 / kDin99ChromaBend);
  const S scale = named("lit_scale", g / max(chroma, S(1e-6)));
  const S e = din.a * scale;
  const S f = din.b * scale * S(1 / kDin99Squeeze);
  return {named("lit_lightness", lightness_of_din99(din.lightness)),
          e * S(kDin99Cos) - f * S(kDin99Sin), e * S(kDin99Sin) + f * S(kDin99Cos)};
}

}  // namespace lumaknot
