/// A planned method's error by part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/measure/method_bench.h"
#include "study/plan/candidates.h"
#include "study/plan/verifier.h"

namespace lumaknot::plan {

/// One part of a method's error.
struct ErrorPart {
  std::string name;
  std::string unit;                 ///< "pixels", or "colour": of the largest channel
  std::optional<double> predicted;  ///< a bound; empty without a simple one
  double measured = 0;              ///< the largest
};

/// Each part of the error of `method`, measured by itself: how far the mesh shows points from their
/// place; the colour that the normal or the light between vertices changes, at the mesh's points;
/// that of the texture's filter and of float, away from edges; of several samples, filter and
/// sampling together against 8 x 8.
std::vector<ErrorPart> error_parts(const measure::Method& method, const KnotSpec& knot,
                                   const Predictor& predictor, measure::MethodBench& bench);

/// The pixels beyond the tolerance because of one part.
struct Attribution {
  std::string part;
  long long pixels = 0;
};

/// Why the closest method does not meet the tolerance, most pixels first: each failing pixel (if
/// none fails and too few are within it in place, each of the others) is attributed to the first
/// part whose exact form fixes it: precision, filter, samples, shading, tessellation; or to edges,
/// where the surface ends or passes behind itself within a pixel.
std::vector<Attribution> attribute(const measure::Method& closest, const Candidates& candidates,
                                   const ToleranceChecker& checker, measure::MethodBench& bench);

}  // namespace lumaknot::plan
