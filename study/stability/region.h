/// A region where a method fails: what is swept, what is measured, and where it fails.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/image.h"

namespace lumaknot::stability {

/// A parameter on its way from where the method holds to where it fails.
struct Sweep {
  std::string parameter;  ///< with its unit
  double from = 0, to = 1;
  bool logarithmic = false;  ///< both ends > 0, steps are factors
  bool whole = false;        ///< whole numbers only
};

/// The error of a method or its remedy at a value of the swept parameter.
using Measurement = std::function<double(double x)>;
/// A picture of it, side x side pixels. Pixels that are not numbers stay so.
using Sketch = std::function<Image(double x, int side)>;

/// Another quantity that is reported next to the error.
struct Quantity {
  std::string name;  ///< with its unit
  Measurement measure;
};

/// A method and where it fails: where its error is above `limit`, or not a number.
struct Region {
  std::string name;   ///< letters, digits and '-'
  std::string group;  ///< the chapter of the page
  std::string method, reason, remedy;
  Sweep sweep;
  std::string measured;  ///< what the error is, with its unit
  double limit = 0;
  Measurement error;
  Measurement guarded;  ///< the error of the remedy; empty if it refuses or changes the question
  std::vector<Quantity> also;     ///< reported at the values that are shown
  Sketch sketch, guarded_sketch;  ///< may be empty
  std::function<std::string(double x)>
      guarded_shows;  ///< what guarded_sketch draws, if not the method's value
  std::optional<double> shown_holds, shown_fails;  ///< where sketches are drawn; else the ends
};

/// Whether `error` is a number and within the region's limit.
bool holds(const Region& region, double error);

/// The parameter at the share `s` in [0, 1] of the way.
double at_share(const Sweep& sweep, double s);

/// `steps` + 1 values evenly from end to end, each once.
std::vector<double> swept_values(const Sweep& sweep, int steps);

/// A value and what was measured there.
struct Measured {
  double x = 0, error = 0;
};

/// Neighbouring swept values that all hold or all fail, from the first to the last of them.
struct SweepInterval {
  double from = 0, to = 0;
};

/// The intervals of `sweep` whose errors are within `limit`, or the others if not `holding`.
std::vector<SweepInterval> stretches(const std::vector<Measured>& sweep, double limit,
                                     bool holding);

/// Two neighbouring values between which the method starts to fail.
struct Boundary {
  Measured holds, fails;
};

inline constexpr double kBoundaryTolerance = 1e-6;  ///< of the way; for whole numbers the next

/// Where the method first fails along `sweep`, the swept values in their order with their errors:
/// the first that fails and its neighbour, brought together by bisection until they are neighbours
/// or kBoundaryTolerance apart. Throws std::logic_error if the first value fails or none does.
Boundary find_boundary(const Region& region, const std::vector<Measured>& sweep);

}  // namespace lumaknot::stability
