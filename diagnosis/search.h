/// The search among hypotheses, single ones and pairs.
#pragma once

#include "diagnosis/fit.h"
#include "system/progress.h"

namespace lumaknot::diagnosis {

/// The explanations found, best first.
struct Found {
  std::vector<Explanation> accepted;
  std::optional<Explanation> nearest;  ///< the best of those that were not accepted
  std::vector<Explanation> screened;   ///< every cause after a few steps on few pixels
};

/// The causes that explain the target alone.
Found search_singles(const Problem& problem, const std::vector<Hypothesis>& hypotheses,
                     const Progress& progress = {});

/// Those that do in pairs, begun with what `singles` saw.
Found search_pairs(const Problem& problem, const std::vector<Hypothesis>& hypotheses,
                   const Found& singles, const Progress& progress = {});

/// Whether the scene as given already explains the target.
bool agrees(const Problem& problem, const Drawn& ours);

}  // namespace lumaknot::diagnosis
