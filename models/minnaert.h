/// Minnaert's diffuse term and Phong's highlight.
#pragma once

#include "models/phong.h"

namespace lumaknot {

/// n.l (n.l n.v)^(k-1): M. Minnaert, "The reciprocity principle in lunar photometry", Astrophysical
/// Journal 93, 1941. Both cosines at least 0, their product at least 1e-4: below it the formula
/// grows without bound where k < 1.
struct MinnaertDiffuse {
  static constexpr std::array kParameters{Parameter{.name = "darkness",
                                                    .value = 1,
                                                    .range = {0, 10},
                                                    .slider = {0, 10},
                                                    .step = 0.01,
                                                    .unit = "exponent",
                                                    .meaning = "1 is Lambert"}};
  static constexpr std::array<EnergySample<1>, 3> kEnergySamples{
      {{"Minnaert, k = 0.25", {0.25}}, {"Minnaert, k = 1", {1}}, {"Minnaert, k = 2", {2}}}};
  static constexpr double kSmallestProduct = 1e-4;

  template <class S>
  static S value(const Directions<S>& d, const S& darkness) {
    const S lit = max(d.n_dot_l, S(0));
    const S seen = named("n_dot_v", max(dot(d.n, d.v), S(0)));
    return lit * power(max(lit * seen, S(kSmallestProduct)), darkness - S(1));
  }
  static double largest(double k) { return std::pow(kSmallestProduct, std::min(k - 1, 0.0)); }
  static std::optional<double> slope(double k) {
    if (k < 1) return {};
    return 2 * k - 1;
  }
  static std::optional<double> interpolation_error(double, double) { return {}; }
  static PovTerm pov(double k) {
    if (k == 1) return {};
    return {"draw Minnaert's diffuse term", "material.darkness 1"};
  }
};

struct Minnaert {
  static constexpr std::string_view kName = "minnaert";
  using Diffuse = MinnaertDiffuse;
  using Highlight = PhongHighlight;
};

}  // namespace lumaknot
