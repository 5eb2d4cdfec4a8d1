/// Two pictures of one shot, compared.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "validate/compare/allowances.h"
#include "validate/compare/explain.h"
#include "validate/compare/sensitivity.h"
#include "validate/compare/shift.h"
#include "validate/renderers/adapter.h"
#include "validate/renderers/limits.h"

namespace lumaknot::validate {

/// kExplained: what differs has a class, but more does than is allowed.
enum class Outcome { kAgreed, kExplained, kDiffered };

/// What the comparison says of a pixel: 0 if nothing, 1 + its PixelClass for an outlier, or one of
/// the last two where one image alone covers it.
using PixelMark = std::uint8_t;
inline constexpr std::array<std::string_view, kPixelClassNames.size() + 3> kPixelMarkNames = [] {
  std::array<std::string_view, kPixelClassNames.size() + 3> names{"within the limit"};
  std::ranges::copy(kPixelClassNames, names.begin() + 1);
  names[names.size() - 2] = "covered by one, an edge beside it";
  names[names.size() - 1] = "covered by one, unexplained";
  return names;
}();
inline constexpr PixelMark kEdgeMark = kPixelMarkNames.size() - 2;
inline constexpr PixelMark kCoverageMark = kPixelMarkNames.size() - 1;

/// How far the errors are from each pixel's own limit.
struct LimitUse {
  double p50 = 0, p99 = 0, p999 = 0,
         max = 0;    ///< of error / limit, inside, without classed outliers
  PixelPlace worst;  ///< where that is largest
  double error = 0;  ///< there
  LimitParts limit;  ///< there; all zero if the user states it
};

/// How another renderer's image of a shot differs from ours. An error is the largest difference of
/// a pixel's three channels; inside means covered in both images and away from silhouettes.
struct Comparison {
  long long covered = 0;               ///< pixels covered in our image
  long long coverage_differs = 0;      ///< pixels covered in one image only
  long long coverage_unexplained = 0;  ///< of those, pixels with no edge near the sample
  bool has_no_coverage = false;        ///< theirs: colours are compared where ours is covered
  long long inside = 0;
  double mean = 0, rmse = 0, p99 = 0, p999 = 0, p9999 = 0, max = 0;
  /// The same for the pixels inside that are not classified outliers.
  double mean_unclassed = 0, p999_unclassed = 0, p9999_unclassed = 0;
  PixelPlace max_at;
  LimitUse use;
  Shift shift;
  double shift_limit = 0;  ///< pixels
  long long outliers = 0;  ///< pixels covered in both whose error exceeds their limit
  std::array<long long, kPixelClassNames.size()> classes{};  ///< the outliers by class
  long long unsearched = 0;  ///< unexplained outliers that no class was tried on: enough others
                             ///< were unexplained for the pictures to differ
  std::vector<ClassShare> shares;       ///< of the classes that occur, and of all together
  std::vector<PixelPlace> unexplained;  ///< the first few of them
  Grid<PixelMark> marks;  ///< of all pixels; released once the report's pictures are made
  /// The limits exceeded, one line each; coverage is a separate rung.
  std::vector<std::string> exceeded;

  Outcome outcome() const;
};

/// What an image is held to.
struct Standard {
  bool limited = false;     ///< colours are limited to [0, 1] first
  double output_steps = 1;  ///< of which the image's values are sums
  Promise promise = {};
  Limits limits = {};  ///< of the user
  Allowances allowances = {};
};

/// `theirs` against `ours`, our own image of `shot`, whose sensitivities are given. An image
/// without any coverage is compared by its colours where ours is covered. On all cores.
Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, const Grid<Sensitivity>& sensitivities,
                   const Standard& standard);

/// The ids of diagnosis's causes for which the comparison has classed pixels: known of the
/// renderer, and no fault of the picture.
std::vector<std::string> classed_causes(const Comparison& comparison);

}  // namespace lumaknot::validate
