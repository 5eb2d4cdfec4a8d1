/// Oren and Nayar's diffuse term and Phong's highlight.
#pragma once

#include "models/phong.h"

namespace lumaknot {

/// n.l (A + B max(0, cos(phi)) sin(a) tan(b)): M. Oren and S. Nayar, "Generalization of Lambert's
/// reflectance model", SIGGRAPH 1994, eq. 30. sin(a) sin(b) cos(phi) is l.v - n.l n.v, so no
/// angle is computed.
struct OrenNayarDiffuse {
  static constexpr std::array kParameters{Parameter{.name = "roughness",
                                                    .value = 0.3,
                                                    .range = {0, 1.57},
                                                    .slider = {0, 1.57},
                                                    .step = 0.01,
                                                    .unit = "none",
                                                    .meaning = "sigma, radians"}};
  static constexpr std::array<EnergySample<1>, 2> kEnergySamples{
      {{"Oren-Nayar, sigma = 0.3", {0.3}}, {"Oren-Nayar, sigma = 1.57", {1.57}}}};

  template <class S>
  static S value(const Directions<S>& d, const S& sigma) {
    const S variance = named("variance", sigma * sigma);
    const S a = S(1) - S(0.5) * variance / (variance + S(0.33));
    const S b = S(0.45) * variance / (variance + S(0.09));
    const S lit = max(d.n_dot_l, S(0));
    const S n_dot_v = named("n_dot_v", dot(d.n, d.v));
    const S across = named("across", max(dot(d.l, d.v) - d.n_dot_l * n_dot_v, S(0)));
    return lit * (a + b * across / max(max(lit, n_dot_v), S(1e-3)));
  }
  /// A + B.
  static double largest(double sigma) {
    const double variance = sigma * sigma;
    return 1 - 0.5 * variance / (variance + 0.33) + 0.45 * variance / (variance + 0.09);
  }
  static std::optional<double> slope(double) { return {}; }
  static std::optional<double> interpolation_error(double, double) { return {}; }
  static PovTerm pov(double sigma) {
    if (sigma == 0) return {};
    return {"draw Oren and Nayar's diffuse term", "material.roughness 0"};
  }
};

struct OrenNayar {
  static constexpr std::string_view kName = "oren-nayar";
  using Diffuse = OrenNayarDiffuse;
  using Highlight = PhongHighlight;
};

}  // namespace lumaknot
