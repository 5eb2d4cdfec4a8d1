/// Lambert's diffuse term and Phong's highlight: the paper's eq. 1 and 2.
#pragma once

#include <cmath>

#include "models/term.h"

namespace lumaknot {

/// max(n.l, 0) (eq. 1).
struct Lambert {
  static constexpr std::array<Parameter, 0> kParameters{};
  static constexpr std::array<EnergySample<0>, 1> kEnergySamples{{{"Lambert", {}}}};

  template <class S>
  static S value(const Directions<S>& d) {
    return max(d.n_dot_l, S(0));
  }
  static double largest() { return 1; }
  static std::optional<double> slope() { return 1; }
  /// turn^2 / 8 times the second derivative; where the light sets in sharply, a quarter of the
  /// change by the slope.
  static std::optional<double> interpolation_error(double turn) {
    return std::min(1.0, turn / 4 + turn * turn / 8);
  }
  static PovTerm pov() { return {}; }
};

/// The exponent of Phong's and Blinn's highlight.
inline constexpr Parameter kShininess{.name = "shininess",
                                      .value = 55,
                                      .range = kNotNegative,
                                      .slider = {0, 256},
                                      .step = 1,
                                      .unit = "exponent",
                                      .meaning = "k of the highlight max(v.R, 0)^k",
                                      .semantic = "SpecularPower"};

/// The properties of the k-th power of the cosine of an angle that changes `rate` times as fast as
/// the normal turns.
template <int rate>
struct PowerOfCosine {
  static constexpr std::array kParameters{kShininess};

  static double largest(double) { return 1; }
  /// The steepest of cos^k, where cos^2 is 1 - 1 / k. Below k = 1 it is vertical at 90 degrees.
  static std::optional<double> slope(double k) {
    if (k == 0) return 0;
    if (k < 1) return {};
    return rate * std::sqrt(k) * std::pow((k - 1) / k, (k - 1) / 2);
  }
  static std::optional<double> interpolation_error(double turn, double k) {
    const double angle = rate * turn;
    return k < 2 ? 1 : std::min(1.0, k * angle * angle / 8);
  }
  static double rounding_growth(double k) { return k; }

 protected:
  static PovTerm pov_lack(double k) {
    if (k != 0) return {};
    return {"draw a highlight of exponent 0 all around", "material.shininess > 0"};
  }
};

/// L_S = max(v.R, 0)^k with R = 2 (L.n) n - L (eq. 2).
struct PhongHighlight : PowerOfCosine<2> {
  static constexpr std::array<EnergySample<1>, 3> kEnergySamples{
      {{"Phong, k = 1", {1}}, {"Phong, k = 10", {10}}, {"Phong, k = 55", {55}}}};

  template <class S>
  static S value(const Directions<S>& d, const S& shininess) {
    const Vec<S> reflection = named("reflection", unit(d.n * (S(2) * d.n_dot_l) - d.l));
    return power(named("r_dot_v", max(dot(reflection, d.v), S(0))), shininess);
  }
  static PovTerm pov(double k) {
    const PovTerm lacking = pov_lack(k);
    return {lacking.lack, lacking.nearest, "phong", "phong_size", k};
  }
  /// (r.v)^k is about Blinn's (n.h)^(4 k).
  static double ggx_roughness(double k) { return std::pow(2 / (4 * k + 2), 0.25); }
};

struct Phong {
  static constexpr std::string_view kName = "phong";
  using Diffuse = Lambert;
  using Highlight = PhongHighlight;
};

}  // namespace lumaknot
