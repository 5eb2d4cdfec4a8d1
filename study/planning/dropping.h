/// Leaving out what no pixel needs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/planning/simplification.h"

namespace lumaknot {

/// A simplification that was made, or not.
struct Tried {
  std::string what;
  std::optional<double> bound;  ///< predicted: no colour changes by more
  double change = 0;            ///< measured: the largest, by it alone; see Dropping::kept
};

/// A scene without what no pixel needs.
struct Dropping {
  Lean lean;
  std::vector<Tried> dropped;
  std::vector<Tried> kept;  ///< changes are with those of all dropped, and of the first pixels that
                            ///< exceed the share: at least so much
  double change = 0;        ///< the largest, by all that was dropped
};

/// `scene` without every light, term, texture and rule that changes the colour of no point by more
/// than `share`, all together: what changes nothing first, then in the order of simplifications().
/// Colours are those of `seen`, in double, limited to [0, 1] as they are shown. Throws
/// Interrupted.
Dropping drop(const Scene& scene, std::span<const Fragment> seen, double share);

}  // namespace lumaknot
