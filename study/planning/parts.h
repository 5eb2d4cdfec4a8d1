/// A planned method's error by part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/planning/workshop.h"

namespace lumaknot {

/// One part of a method's error.
struct ErrorPart {
  std::string name;
  std::string unit;                 ///< "pixels", or "colour": of the largest channel
  std::optional<double> predicted;  ///< a bound; none where nothing simple bounds it
  double measured = 0;              ///< the largest
};

/// Each part of what `method` errs by, measured by itself: how far the mesh shows points from their
/// place; the colour that the normal or the light between vertices changes, at the mesh's points;
/// that of the texture's filter and of float, away from edges; of several samples, filter and
/// sampling together against 8 x 8.
std::vector<ErrorPart> error_parts(const Method& method, const KnotSpec& knot,
                                   const Predictor& predictor, Workshop& workshop);

/// Pixels beyond the tolerance that one part is to blame for.
struct Blame {
  std::string part;
  long long pixels = 0;
};

/// Why the closest method does not meet the tolerance, most pixels first: each pixel that fails is
/// put to the first part whose exact form mends it: precision, filter, samples, shading,
/// tessellation; or to edges, where the surface ends or passes behind itself within a pixel.
std::vector<Blame> blame(const Method& closest, const Choices& choices, const Judge& judge,
                         Workshop& workshop);

}  // namespace lumaknot
