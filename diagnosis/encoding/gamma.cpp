/// Gamma, or the transfer function of sRGB.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> gamma(const Situation&) {
  std::vector<Hypothesis> all{
      continuous("gamma", Rung::kEncoding, {"gamma", 1, 0.02, 0.1, 10}, "gamma {:.4g}",
                 [](Setup& s, double gamma) { s.color.gamma = gamma; }),
      discrete("srgb-encoded", Rung::kEncoding, "an encoding as sRGB",
               [](Setup& s) { s.color.curve = Curve::kEncodeSrgb; }),
      discrete("srgb-decoded", Rung::kEncoding, "a decoding from sRGB",
               [](Setup& s) { s.color.curve = Curve::kDecodeSrgb; })};
  all[1].special = all[2].special = true;
  return all;
}

}  // namespace lumaknot::diagnosis
