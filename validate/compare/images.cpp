#include "validate/compare/images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "validate/compare/quantile.h"

namespace lumaknot::validate {
namespace {

/// One pixel covered in both images.
struct PixelError {
  double error;
  PixelPlace place;
  bool inside, classed;
};

double mean_of(const std::vector<double>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 0 : sum / double(values.size());
}

void summarise(std::vector<PixelError> pixels, Comparison& result) {
  std::erase_if(pixels, [](const PixelError& p) { return !p.inside; });
  std::vector<double> all, squares, unclassed;
  for (const PixelError& p : pixels) {
    all.push_back(p.error);
    squares.push_back(p.error * p.error);
    if (!p.classed) unclassed.push_back(p.error);
    if (p.error > result.max) result.max = p.error, result.max_at = p.place;
  }
  std::ranges::sort(all);
  std::ranges::sort(unclassed);
  result.inside = (long long)all.size();
  result.mean = mean_of(all);
  result.rmse = std::sqrt(mean_of(squares));
  result.p99 = quantile(all, 0.99);
  result.p999 = quantile(all, 0.999);
  result.p9999 = quantile(all, 0.9999);
  result.mean_unclassed = mean_of(unclassed);
  result.p999_unclassed = quantile(unclassed, 0.999);
  result.p9999_unclassed = quantile(unclassed, 0.9999);
}

void check(const Limits& limits, Comparison& result) {
  const auto at_most = [&](std::string_view what, double value, double limit) {
    if (value <= limit) return;
    result.exceeded.push_back(fmt::format("{} {:.3g} > {:.3g}", what, value, limit));
  };
  at_most("mean", result.mean_unclassed, limits.mean);
  at_most("p99.9", result.p999_unclassed, limits.p999);
  at_most("p99.99", result.p9999_unclassed, limits.p9999);
  at_most("unexplained outliers", double(result.classes[std::size_t(PixelClass::kUnexplained)]),
          double(limits.unexplained));
}

}  // namespace

namespace {

/// With more unexplained pixels than this the pictures differ as a whole, and the costly search for
/// an edge near each sample stops.
constexpr long long kMaxSearched = 1000;

/// Classifies an outlier and counts it.
PixelClass count_outlier(const Reference& reference, const Shot& shot, const TheirPixel& theirs,
                         Comparison& result) {
  constexpr std::size_t kMaxPlaces = 10;
  const PixelClass why = explain(reference, shot, theirs);
  ++result.outliers;
  ++result.classes[std::size_t(why)];
  if (why == PixelClass::kUnexplained && result.unexplained.size() < kMaxPlaces) {
    result.unexplained.push_back(theirs.place);
  }
  return why;
}

void count_coverage(const Reference& reference, PixelPlace place, double edge, Comparison& result) {
  ++result.coverage_differs;
  const bool search = result.coverage_unexplained < kMaxSearched;
  if (!search || !explains_coverage(reference, place, edge)) ++result.coverage_unexplained;
}

}  // namespace

Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, bool limited, const Limits& limits) {
  Comparison result;
  std::vector<PixelError> pixels;
  for (int y = 0; y < theirs.height; ++y) {
    for (int x = 0; x < theirs.width; ++x) {
      const bool covered = ours.at(x, y).coverage > 0.5f;
      const RgbaPixel& their = theirs.at(x, y);
      result.covered += covered;
      if (covered != (their.coverage > 0.5f)) {
        count_coverage(reference, {x, y}, limits.edge, result);
        continue;
      }
      if (!covered) continue;
      PixelError pixel{channel_error(to_vec(ours.at(x, y).color), their.color, limited),
                       {x, y},
                       reference.silhouettes.at(x, y) == 0,
                       false};
      if (!(pixel.error <= limits.outlier)) {
        const bool search = result.classes[std::size_t(PixelClass::kUnexplained)] < kMaxSearched;
        const PixelClass why = count_outlier(
            reference, shot, {{x, y}, their.color, limits.outlier, limits.edge, limited, search},
            result);
        pixel.classed = why != PixelClass::kUnexplained;
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

}  // namespace lumaknot::validate
