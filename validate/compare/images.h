/// Two pictures of one shot, compared.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "validate/compare/allowances.h"
#include "validate/compare/explain.h"
#include "validate/renderers/adapter.h"
#include "validate/renderers/limits.h"

namespace lumaknot::validate {

/// kExplained: what differs has a class, but more does than is allowed.
enum class Outcome { kAgreed, kExplained, kDiffered };

/// How another renderer's image of a shot differs from ours. An error is the largest difference of
/// a pixel's three channels; inside means covered in both images and away from silhouettes.
struct Comparison {
  long long covered = 0;               ///< pixels covered in our image
  long long coverage_differs = 0;      ///< pixels covered in one image only
  long long coverage_unexplained = 0;  ///< of those, pixels with no edge near the sample
  bool has_no_coverage = false;        ///< theirs: colours are compared where ours is covered
  long long inside = 0;
  double mean = 0, rmse = 0, p99 = 0, p999 = 0, p9999 = 0, max = 0;
  /// The same for the pixels inside that are not classified outliers; the limits apply to these.
  double mean_unclassed = 0, p999_unclassed = 0, p9999_unclassed = 0;
  PixelPlace max_at;
  long long outliers = 0;  ///< pixels covered in both whose error exceeds Limits::outlier
  std::array<long long, kPixelClassNames.size()> classes{};  ///< the outliers by class
  long long unsearched = 0;  ///< unexplained outliers that no class was tried on: enough others
                             ///< were unexplained for the pictures to differ
  std::vector<ClassShare> shares;       ///< of the classes that occur, and of all together
  std::vector<PixelPlace> unexplained;  ///< the first few of them
  /// The limits exceeded, one line each; coverage is a separate rung.
  std::vector<std::string> exceeded;

  Outcome outcome() const;
};

/// `theirs` against `ours`, our own image of `shot`. With `limited`, both are limited to [0, 1]
/// first. An image without any coverage is compared by its colours where ours is covered. On all
/// cores.
Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, bool limited, const Limits& limits,
                   const Allowances& allowances = {});

/// |a - b| x 16, limited to [0, 1] as in any image file; black where neither is covered.
Image difference(const Image& a, const Image& b, bool limited);

}  // namespace lumaknot::validate
