/// Removes what no pixel needs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/plan/simplification.h"

namespace lumaknot::plan {

/// A simplification, applied or not.
struct Attempt {
  std::string what;
  std::optional<double> bound;  ///< predicted: no colour changes by more than this
  double change = 0;            ///< measured: the largest, by it alone; see Pruning::kept
};

/// A scene without what no pixel needs.
struct Pruning {
  SimplifiedScene simplified;
  std::vector<Attempt> dropped;
  std::vector<Attempt> kept;  ///< changes include those of all dropped, and are of the first
                              ///< pixels that exceed the share: at least this much
  double change = 0;          ///< the largest, by all that was dropped
};

/// `scene` without all lights, terms, textures and rules that together change no point's colour by
/// more than `share`: what changes nothing first, then in the order of simplifications().
/// Colours are those of `seen`, in double, limited to [0, 1] as displayed. Throws
/// Interrupted.
Pruning drop(const Scene& scene, std::span<const Fragment> seen, double share);

}  // namespace lumaknot::plan
