/// Whether the colours that a language computed are those of the formula.
#pragma once

#include <string>
#include <vector>

#include "tests/kernel/cells.h"
#include "tests/kernel/rows.h"

namespace lumaknot::testing {

/// How precise a language's arithmetic is: error_models.h.
enum class Precision {
  kCycles,  ///< float, functions accurate to the last place: Blender's nodes
  kVulkan,  ///< float, as Vulkan requires: software drivers
  kOsl,     ///< float, functions as measured: Blender's OSL
  kDouble   ///< POV-Ray
};

/// Of full scale: the tolerance of every well-conditioned formula in float.
inline constexpr double kFullScaleTolerance = 2e-5;
/// The same in double: ten thousand last places.
inline constexpr double kDoubleTolerance = 1e-12;

/// Errors are relative to colours beyond 1.
struct Verdict {
  double largest_error = 0;     ///< of rows that are not at an edge
  double share_within = 1;      ///< of the rows that keep the tolerance
  double largest_bound = 0;     ///< of those that do not: their bound, rounding_bound.h
  std::size_t enclosed = 0;     ///< rows at an edge: checked against enclosure.h's box instead
  double largest_enclosed = 0;  ///< their largest error
  std::size_t failures = 0;     ///< rows beyond both
  std::string failure;  ///< the first, or that too many rows are at an edge; empty on success
};

Precision precision_of(Language language);

/// Judges `found`, one colour per row. Each channel must keep the tolerance, or the bound of that
/// very row; or at an edge, where that bound does not hold (a rounding may change the side of a
/// choice) or says little (it is beyond a fiftieth of full scale), the row's box: one row in a
/// hundred at most.
Verdict judged(const ShaderJob& job, const KernelRows& rows, const std::vector<Vec3d>& found,
               Precision precision);

/// Adds a line to the file that the environment variable LUMAKNOT_KERNEL_TABLE names, if it does:
/// language, formula, variant, largest_error, share_within, largest_bound, enclosed,
/// largest_enclosed, failures; tabs between.
void add_to_table(const std::string& language, const KernelCell& cell, const Verdict& verdict);

}  // namespace lumaknot::testing
