/// Saturation and hue.
#include "diagnosis/cause.h"
#include "math/angle.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> hue(const Situation&) {
  std::vector<Hypothesis> all{
      continuous("saturation", Rung::kEncoding, {"saturation", 1, 0.02, -2, 10},
                 "a saturation of {:.4g}",
                 [](Setup& s, double saturation) { s.color.saturation = saturation; }),
      discrete("grey", Rung::kEncoding, "its colours turned to grey",
               [](Setup& s) { s.color.saturation = 0; }),
      continuous("hue", Rung::kEncoding, {"degrees", 0, 1, -180, 180},
                 "its hues turned by {:.4g} degrees",
                 [](Setup& s, double degrees) { s.color.hue = degrees * kDegree; }),
      discrete("negative", Rung::kEncoding, "its colours inverted",
               [](Setup& s) { s.color.inverted = true; })};
  all[1].special = true;
  all[2].starts = {{0}, {90}, {-90}, {180}};
  return all;
}

}  // namespace lumaknot::diagnosis
