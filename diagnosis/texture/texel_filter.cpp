/// Texels filtered otherwise, or off by half a texel.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> texel_filter(const Situation& situation) {
  if (!has_image(situation)) return {};
  Hypothesis texels = continuous("texel-shift", Rung::kTexture, {"texels", 0, 0.05, -8, 8},
                                 "the texture moved by {:.3g} texels",
                                 [](Setup& s, double by) { s.texturing.texel_shift = by; });
  texels.starts = {{0.25}, {-0.25}};
  Hypothesis half = discrete("half-texel", Rung::kTexture,
                             "the texture off by half a texel (texel centres at whole numbers)",
                             [](Setup& s) { s.texturing.texel_shift = 0.5; });
  half.special = true;
  Hypothesis other_half =
      discrete("half-texel-back", Rung::kTexture, "the texture off by half a texel, backwards",
               [](Setup& s) { s.texturing.texel_shift = -0.5; });
  other_half.special = true;
  return {
      discrete("texture-nearest", Rung::kTexture, "the nearest texel instead of bilinear filtering",
               [](Setup& s) { s.texturing.sampling = Sampling::kNearest; }),
      discrete("texture-mipmapped", Rung::kTexture, "a mip-mapped texture",
               [](Setup& s) { s.texturing.sampling = Sampling::kMipmapped; }),
      discrete("texture-clamped", Rung::kTexture,
               "the texture clamped to its edge instead of repeated",
               [](Setup& s) { s.texturing.wrapping = Wrapping::kClamp; }),
      texels,
      half,
      other_half};
}

}  // namespace lumaknot::diagnosis
