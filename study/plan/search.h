/// The cheapest method that meets a tolerance.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "study/plan/trials.h"

namespace lumaknot::plan {

/// The fastest method that was found to meet the tolerance; empty if none does. The coarsest grid
/// of each method is timed, and the fastest method comes first; its bisection begins where the
/// prediction says that the tolerance is met, and only measurements count. A method whose coarsest
/// grid is already slower than the best so far is left out, and in double also the same method with
/// more samples, untimed.
std::optional<measure::Method> fastest_that_meets(const Candidates& candidates,
                                                  const Predictor& predictor, Trials& trials,
                                                  int rounds, const Progress& progress);

/// The same by measuring every grid of every method, and timing all that meet the tolerance, except
/// methods whose coarsest grid takes twice as long as `chosen`; that is timed in the same rounds.
std::optional<measure::Method> fastest_of_all(const Candidates& candidates,
                                              const std::optional<measure::Method>& chosen,
                                              Trials& trials, int rounds, const Progress& progress);

/// The method that lacks the fewest pixels in place, and of those the one with the smallest
/// measured error; of equals the first.
measure::Method closest_method(const Candidates& candidates, const MeasurementStore& store);

}  // namespace lumaknot::plan
