/// The cost of formulas: frames of one scene with each, in turns.
#pragma once

#include <string>
#include <vector>

#include "render/reference.h"
#include "scene/spec.h"
#include "study/measure/statistics.h"

namespace lumaknot::paper {

/// A formula to time, by its name in scene/presets.h.
struct FormulaTime {
  std::string formula;
  measure::Spread milliseconds;  ///< per frame
  double cost = 0;               ///< share of the first formula's frame rate that is lost
};

/// Frames of our fast renderer on one thread, trilinear, one sample per pixel: formula after
/// formula, round after round, for `seconds`, each at least three times. Throws Interrupted.
std::vector<FormulaTime> time_formulas(const Scene& scene, const std::vector<std::string>& formulas,
                                       double seconds, const Progress& progress = {});

}  // namespace lumaknot::paper
