/// The cheapest way to draw that meets a tolerance.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "study/planning/workshop.h"

namespace lumaknot {

/// The fastest method that was found to meet the tolerance; none where nothing does. Each way's
/// coarsest grid is timed, the fastest way comes first; where the prediction says that the
/// tolerance is met its bisection begins, and what counts is what is measured. A way whose coarsest
/// grid is already slower than the best that was found is left out, and in double the same way with
/// more samples, untimed.
std::optional<Method> fastest_that_meets(const Choices& choices, const Predictor& predictor,
                                         Workshop& workshop, int rounds, const Progress& progress);

/// The same by measuring every grid of every way, and timing all that meet the tolerance but ways
/// whose coarsest grid takes twice as long as `chosen`; that too, in the same rounds.
std::optional<Method> fastest_of_all(const Choices& choices, const std::optional<Method>& chosen,
                                     Workshop& workshop, int rounds, const Progress& progress);

/// Of all that was measured, the one with the least error; of equals the first.
Method closest_method(const Choices& choices, const Notebook& notebook);

}  // namespace lumaknot
