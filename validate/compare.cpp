#include "validate/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lumaknot {
namespace {

/// The smallest value that a share `q` of the sorted `values` does not exceed; 0 without values.
double quantile(const std::vector<double>& sorted, double q) {
  if (sorted.empty()) return 0;
  const double rank = std::ceil(q * double(sorted.size()));
  return sorted[std::size_t(std::max(rank, 1.0)) - 1];
}

/// One pixel covered in both images.
struct PixelError {
  double error;
  PixelPlace place;
  bool inside, classed;
};

void summarise(std::vector<PixelError> pixels, Comparison& result) {
  std::erase_if(pixels, [](const PixelError& p) { return !p.inside; });
  std::vector<double> all, unclassed;
  double sum = 0, squares = 0;
  for (const PixelError& p : pixels) {
    all.push_back(p.error);
    if (!p.classed) unclassed.push_back(p.error);
    sum += p.error;
    squares += p.error * p.error;
    if (p.error > result.max) result.max = p.error, result.max_at = p.place;
  }
  std::ranges::sort(all);
  std::ranges::sort(unclassed);
  result.inside = (long long)all.size();
  const double count = double(std::max<std::size_t>(1, all.size()));
  result.mean = sum / count;
  result.rmse = std::sqrt(squares / count);
  result.p99 = quantile(all, 0.99);
  result.p999 = quantile(all, 0.999);
  result.p9999 = quantile(all, 0.9999);
  result.p9999_unclassed = quantile(unclassed, 0.9999);
}

void check(const Limits& limits, Comparison& result) {
  const auto at_most = [&](std::string_view what, double value, double limit) {
    if (value <= limit) return;
    result.exceeded.push_back(fmt::format("{} {:.3g} > {:.3g}", what, value, limit));
  };
  at_most("coverage", double(result.coverage_differs), double(limits.coverage));
  at_most("mean", result.mean, limits.mean);
  at_most("p99.9", result.p999, limits.p999);
  at_most("max", result.max, limits.max);
  at_most("p99.99 without classed outliers", result.p9999_unclassed, limits.p9999_unclassed);
  at_most("unexplained outliers", double(result.classes[std::size_t(PixelClass::kUnexplained)]), 0);
}

}  // namespace

Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, bool limited, const Limits& limits) {
  constexpr std::size_t kMostPlaces = 10;
  Comparison result;
  std::vector<PixelError> pixels;
  for (int y = 0; y < theirs.height; ++y) {
    for (int x = 0; x < theirs.width; ++x) {
      const Fragment& fragment = reference.fragments.at(x, y);
      const RgbaPixel& their = theirs.at(x, y);
      result.covered += fragment.covered();
      result.coverage_differs += fragment.covered() != (their.coverage > 0.5f);
      if (!fragment.covered() || their.coverage <= 0.5f) continue;
      const bool at_silhouette = reference.silhouettes.at(x, y) != 0;
      PixelError pixel{channel_error(to_vec(ours.at(x, y).color), their.color, limited),
                       {x, y},
                       !at_silhouette,
                       false};
      if (!(pixel.error <= limits.outlier)) {
        const PixelClass why = explain(reference.scene, shot, fragment, at_silhouette, their.color,
                                       limits.outlier, limited);
        ++result.outliers;
        ++result.classes[std::size_t(why)];
        pixel.classed = why != PixelClass::kUnexplained;
        if (!pixel.classed && result.unexplained.size() < kMostPlaces) {
          result.unexplained.push_back({x, y});
        }
      }
      pixels.push_back(pixel);
    }
  }
  summarise(std::move(pixels), result);
  check(limits, result);
  return result;
}

Image difference(const Image& a, const Image& b, bool limited) {
  constexpr float kGain = 16;
  const auto value = [limited](float v) { return limited ? std::clamp(v, 0.0f, 1.0f) : v; };
  Image result(a.width, a.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const Rgb &p = a.pixels[i].color, &q = b.pixels[i].color;
    result.pixels[i].color = {kGain * std::abs(value(p.r) - value(q.r)),
                              kGain * std::abs(value(p.g) - value(q.g)),
                              kGain * std::abs(value(p.b) - value(q.b))};
    result.pixels[i].coverage = 1;
  }
  return result;
}

}  // namespace lumaknot
