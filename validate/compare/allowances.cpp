#include "validate/compare/allowances.h"

#include <algorithm>
#include <cmath>

namespace lumaknot::validate {
namespace {

/// The shares of a picture that need no permission, by kAllowanceNames. Smooth normals face away
/// at the rims of common meshes in up to 0.3 % of the covered pixels, and float32 coordinates are
/// at a texel's edge in as many. A sample is within 1/128 pixel of a silhouette, on either side, at
/// 1.6 % of its pixels. One ray in 100,000 slips.
constexpr std::array<double, kAllowanceNames.size()> kUsual{0.01,  0.01, 0.01, 0.03,
                                                            0.001, 0.03, 0.02};

}  // namespace

bool is_of_silhouette(std::size_t allowance) {
  return allowance == std::size_t(PixelClass::kSilhouette) || allowance == kCoverageAllowance;
}

std::string_view allowance_title(std::size_t allowance) {
  if (allowance == kCoverageAllowance) return "coverage";
  return allowance == kTotalAllowance ? "all classes together" : kPixelClassNames[allowance];
}

long long count_within(double share, long long of) {
  const double expected = share * double(of);
  return (long long)(std::floor(expected + 3 * std::sqrt(expected)));
}

ClassShare class_share(std::size_t allowance, long long count, long long covered,
                       long long silhouette_length, const Allowances& allowances) {
  ClassShare result{allowance, count, is_of_silhouette(allowance) ? silhouette_length : covered,
                    allowances.stated[allowance].value_or(kUsual[allowance]), false};
  result.exceeded = allowances.stated[allowance] ? double(count) > result.cap * double(result.of)
                                                 : count > count_within(result.cap, result.of);
  return result;
}

std::vector<ClassShare> exceeded_shares(std::vector<ClassShare> shares) {
  std::erase_if(shares, [](const ClassShare& s) { return !s.exceeded; });
  const auto is_total = [](const ClassShare& s) { return s.allowance == kTotalAllowance; };
  if (!std::ranges::all_of(shares, is_total)) std::erase_if(shares, is_total);
  return shares;
}

}  // namespace lumaknot::validate
