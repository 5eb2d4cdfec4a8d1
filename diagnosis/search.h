/// The search among hypotheses, single ones and pairs.
#pragma once

#include "diagnosis/fit.h"
#include "system/progress.h"

namespace lumaknot::diagnosis {

/// The explanations found, best first.
struct Found {
  std::vector<Explanation> accepted;
  std::optional<Explanation> nearest;  ///< the best of those that were not accepted
};

/// All causes that alone, or else in pairs, explain the target.
Found search(const Problem& problem, const std::vector<Hypothesis>& hypotheses,
             const Progress& progress = {});

/// Whether the scene as given already explains the target.
bool agrees(const Problem& problem, const Drawn& ours);

}  // namespace lumaknot::diagnosis
