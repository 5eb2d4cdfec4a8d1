/// The texture decoded, encoded, without colour or with its channels exchanged.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> texel_color(const Situation& situation) {
  if (!has_image(situation)) return {};
  std::vector<Hypothesis> all{
      continuous("texture-gamma", Rung::kTexture, {"exponent", 1, 0.02, 0.1, 10},
                 "the texture raised to the power {:.4g}",
                 [](Setup& s, double exponent) { s.texturing.gamma = exponent; }),
      discrete("texture-decoded-late", Rung::kTexture,
               "the texture decoded from sRGB after filtering",
               [](Setup& s) {
                 s.texturing.curve = Curve::kDecodeSrgb;
                 s.texturing.after_filtering = true;
               }),
      discrete("texture-decoded", Rung::kTexture, "the texture decoded from sRGB",
               [](Setup& s) { s.texturing.curve = Curve::kDecodeSrgb; }),
      discrete("texture-encoded", Rung::kTexture, "the texture encoded as sRGB",
               [](Setup& s) { s.texturing.curve = Curve::kEncodeSrgb; }),
      continuous("texture-saturation", Rung::kTexture, {"saturation", 1, 0.02, -2, 5},
                 "the texture's saturation times {:.4g}",
                 [](Setup& s, double saturation) { s.texturing.saturation = saturation; }),
      discrete("texture-grey", Rung::kTexture, "the texture in grey",
               [](Setup& s) { s.texturing.saturation = 0; })};
  all.back().special = true;
  for (const Permutation& p : kPermutations) {
    all.push_back(discrete(fmt::format("texture-channels-{}", p.name), Rung::kTexture,
                           fmt::format("the texture's channels in the order {}", p.name),
                           [p](Setup& s) { s.texturing.channels = p.order; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
