/// Lambert's diffuse term and Blinn's highlight.
#pragma once

#include "models/phong.h"

namespace lumaknot {

/// max(n.h, 0)^k: J. Blinn, "Models of light reflection for computer synthesized pictures",
/// SIGGRAPH 1977.
struct BlinnHighlight : PowerOfCosine<1> {
  static constexpr std::array<EnergySample<1>, 3> kEnergySamples{
      {{"Blinn-Phong, k = 1", {1}}, {"Blinn-Phong, k = 10", {10}}, {"Blinn-Phong, k = 55", {55}}}};

  template <class S>
  static S value(const Directions<S>& d, const S& shininess) {
    const Vec<S> half = named("half_way", unit(d.l + d.v));
    return power(named("n_dot_h", max(dot(d.n, half), S(0))), shininess);
  }
  /// POV-Ray's roughness is the inverse of the exponent.
  static PovTerm pov(double k) {
    const PovTerm lacking = pov_lack(k);
    return {lacking.lack, lacking.nearest, "specular", "roughness", 1 / k};
  }
  /// alpha^2 = 2 / (k + 2): Walter et al. 2007, section 5.2, of Beckmann's lobe.
  static double ggx_roughness(double k) { return std::pow(2 / (k + 2), 0.25); }
};

struct BlinnPhong {
  static constexpr std::string_view kName = "blinn-phong";
  using Diffuse = Lambert;
  using Highlight = BlinnHighlight;
};

}  // namespace lumaknot
