/// How much of a picture may differ for reasons that were recomputed and found to hold.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "validate/compare/explain.h"

namespace lumaknot::validate {

/// What may be allowed by its share, as written on the command line: the classes of pixels in the
/// order of PixelClass, then pixels covered in one picture only, then all classes together.
inline constexpr std::array<std::string_view, 7> kAllowanceNames{
    "turned-normal", "gated-highlight", "texel-edge", "silhouette",
    "slipped-ray",   "coverage",        "all"};
inline constexpr std::size_t kCoverageAllowance = 5, kTotalAllowance = 6;

/// Shares in [0, 1] that the user allows, by kAllowanceNames; empty: the usual ones.
struct Allowances {
  std::array<std::optional<double>, kAllowanceNames.size()> stated;
};

/// The pixels of one class, and how many of them are allowed.
struct ClassShare {
  std::size_t allowance = 0;  ///< its index in kAllowanceNames
  long long count = 0;
  long long of = 0;  ///< the covered pixels, or the silhouette's length in pixels
  double cap = 0;    ///< the share allowed, in [0, 1]
  bool exceeded = false;

  double share() const { return of > 0 ? double(count) / double(of) : 0; }
};

/// Whether shares of this allowance are of the silhouette's length, not of the covered pixels.
bool is_of_silhouette(std::size_t allowance);

/// "turned normal"
std::string_view allowance_title(std::size_t allowance);

/// The largest count whose share of `of` doesn't exceed `share`, with three standard deviations of
/// such a count on top: pictures of few pixels aren't judged by chance.
long long count_within(double share, long long of);

/// A class of `count` pixels against its allowance.
ClassShare class_share(std::size_t allowance, long long count, long long covered,
                       long long silhouette_length, const Allowances& allowances);

/// Those beyond what is allowed; all classes together only if no class is by itself.
std::vector<ClassShare> exceeded_shares(std::vector<ClassShare> shares);

}  // namespace lumaknot::validate
