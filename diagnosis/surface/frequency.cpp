/// Light computed per vertex instead of per pixel, or the other way round.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> frequency(const Situation& situation) {
  if (situation.setup.view.material.rate == ShadingFrequency::kVertex) {
    return {discrete("light-per-pixel", Rung::kSurface, "light computed per pixel",
                     [](Setup& s) { s.view.material.rate = ShadingFrequency::kPixel; })};
  }
  return {discrete("light-per-vertex", Rung::kSurface, "light computed per vertex and interpolated",
                   [](Setup& s) { s.view.material.rate = ShadingFrequency::kVertex; })};
}

}  // namespace lumaknot::diagnosis
