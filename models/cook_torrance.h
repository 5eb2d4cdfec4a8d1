/// Lambert's diffuse term and the highlight of microfacets.
#pragma once

#include <limits>

#include "models/phong.h"

namespace lumaknot {

/// pi D V F n.l: R. Cook and K. Torrance, "A reflectance model for computer graphics", 1982, with
/// the GGX distribution (B. Walter et al., "Microfacet models for refraction through rough
/// surfaces", EGSR 2007), Smith's height-correlated visibility (E. Heitz, JCGT 2014) and Schlick's
/// Fresnel term (1994). alpha = roughness^2. The factor pi is the convention in which a white
/// Lambert surface answers n.l. 1 - (n.h)^2 is taken as |n x h|^2, which stays exact in float.
struct CookTorranceHighlight {
  static constexpr std::array kParameters{
      Parameter{.name = "roughness",
                .value = 0.3,
                .range = {0.04, 1.57},  // at 0.04 the highlight is 6e-4 radians wide
                .slider = {0, 1.57},
                .step = 0.01,
                .unit = "none",
                .meaning = "square root of alpha"},
      Parameter{.name = "reflectance",
                .value = 0.04,
                .range = {0, 1},
                .slider = {0, 1},
                .step = 0.01,
                .unit = "of white",
                .meaning = "head on, F0"}};
  static constexpr std::array<EnergySample<2>, 3> kEnergySamples{
      {{"Cook-Torrance, roughness 0.3, F0 = 1", {0.3, 1}},
       {"Cook-Torrance, roughness 0.6, F0 = 1", {0.6, 1}},
       {"Cook-Torrance, roughness 1, F0 = 1", {1, 1}}}};

  template <class S>
  static S value(const Directions<S>& d, const S& roughness, const S& reflectance) {
    const S alpha = named("alpha", max(roughness * roughness, S(1e-3)));
    const S alpha2 = named("alpha2", alpha * alpha);
    const Vec<S> half = named("half_way", unit(d.l + d.v));
    const S n_dot_h = named("n_dot_h", max(dot(d.n, half), S(0)));
    const Vec<S> n_cross_h = named("n_cross_h", cross(d.n, half));
    // Of unit vectors it is at least this; without a normal or with l = -v there is no half way.
    const S smallest = min(alpha2, S(1));
    const S spread =
        named("spread", max(alpha2 * n_dot_h * n_dot_h + dot(n_cross_h, n_cross_h), smallest));
    const S lit = named("lit", max(d.n_dot_l, S(0)));
    // An eye below the surface's horizon sees no highlight; there l + v may be any small vector.
    const S n_dot_v = named("n_dot_v", dot(d.n, d.v));
    const S seen = named("seen", max(n_dot_v, S(1e-3)));
    const S above = saturate(n_dot_v * S(1e3));
    const S shadowed = lit * sqrt(max(seen * seen * (S(1) - alpha2) + alpha2, S(0)));
    const S masked = seen * sqrt(max(lit * lit * (S(1) - alpha2) + alpha2, S(0)));
    const S away = named("away", S(1) - max(dot(d.v, half), S(0)));
    const S away2 = away * away;
    const S fresnel = reflectance + (S(1) - reflectance) * (away2 * away2 * away);
    return above * alpha2 * fresnel * lit * S(0.5) / (spread * spread * (shadowed + masked));
  }
  static double largest(double, double) { return std::numeric_limits<double>::infinity(); }
  static std::optional<double> slope(double, double) { return {}; }
  static std::optional<double> interpolation_error(double, double, double) { return {}; }
  static double rounding_growth(double, double) { return std::numeric_limits<double>::infinity(); }
  static PovTerm pov(double, double) {
    return {"draw the highlights of Cook and Torrance", "material.model \"blinn-phong\""};
  }
  static double ggx_roughness(double roughness, double) { return std::min(roughness, 1.0); }
};

struct CookTorrance {
  static constexpr std::string_view kName = "cook-torrance";
  using Diffuse = Lambert;
  using Highlight = CookTorranceHighlight;
};

}  // namespace lumaknot
