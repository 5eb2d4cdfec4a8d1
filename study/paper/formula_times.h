/// What formulas cost: frames of one scene with each, taken in turns.
#pragma once

#include <string>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"
#include "study/statistics.h"

namespace lumaknot {

/// A formula to time, by its name in scene/presets.h.
struct FormulaTime {
  std::string formula;
  Spread milliseconds;  ///< a frame: median, least, most
  double cost = 0;      ///< share of the first formula's frame rate that is lost
};

/// Frames of our fast renderer on one thread, trilinear, one sample a pixel: formula after formula,
/// round after round, for `seconds`, each at least thrice. Throws Interrupted.
std::vector<FormulaTime> time_formulas(const Scene& scene, const std::vector<std::string>& formulas,
                                       double seconds, const Progress& progress = {});

}  // namespace lumaknot
