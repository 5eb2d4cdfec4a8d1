/// Shadows, which the technique does not draw.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> shadow(const Situation&) {
  return {discrete("shadows", Rung::kLight, "shadows", [](Setup& s) { s.shadows = true; })};
}

}  // namespace lumaknot::diagnosis
