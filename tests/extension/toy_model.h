// A model in one file: light that wraps around the surface, with a parameter of its own, and
// Blinn's highlight.
#pragma once

#include "models/blinn_phong.h"

namespace lumaknot {

/// max(n.l + w, 0) / (1 + w).
struct ToyDiffuse {
  static constexpr std::array kParameters{Parameter{.name = "wrap",
                                                    .value = 0.5,
                                                    .range = {0, 1},
                                                    .slider = {0, 1},
                                                    .step = 0.01,
                                                    .unit = "cosine",
                                                    .meaning = "how far light reaches around"}};
  static constexpr std::array<EnergySample<1>, 1> kEnergySamples{{{"Toy, wrap = 0.5", {0.5}}}};

  template <class S>
  static S value(const Directions<S>& d, const S& wrap) {
    return max(d.n_dot_l + wrap, S(0)) / (S(1) + wrap);
  }
  static double largest(double) { return 1; }
  static std::optional<double> slope(double wrap) { return 1 / (1 + wrap); }
  static std::optional<double> interpolation_error(double, double) { return {}; }
  static PovTerm pov(double wrap) {
    if (wrap == 0) return {};
    return {"draw the toy's diffuse term", "material.wrap 0"};
  }
};

struct Toy {
  static constexpr std::string_view kName = "toy";
  using Diffuse = ToyDiffuse;
  using Highlight = BlinnHighlight;
};

}  // namespace lumaknot
