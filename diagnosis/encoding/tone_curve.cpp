/// A tone curve.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> tone_curve(const Situation&) {
  return {discrete("tone-reinhard", Rung::kEncoding, "Reinhard's tone curve, c / (1 + c)",
                   [](Setup& s) { s.color.curve = Curve::kReinhard; }),
          discrete("tone-aces", Rung::kEncoding, "Narkowicz's fit of the ACES tone curve",
                   [](Setup& s) { s.color.curve = Curve::kAces; })};
}

}  // namespace lumaknot::diagnosis
