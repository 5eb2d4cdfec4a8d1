#include "validate/compare/images.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "validate/compare/quantile.h"

namespace lumaknot::validate {
namespace {

/// One pixel covered in both images.
struct PixelError {
  double error;
  PixelPlace place;
  bool inside;
  std::optional<PixelClass> why;  ///< of an outlier

  bool classed() const { return why && *why != PixelClass::kUnexplained; }
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
    if (!p.classed()) unclassed.push_back(p.error);
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

/// The unexplained pixels that the limits grant.
long long granted(const Limits& limits, const Reference& reference) {
  return count_within(limits.unexplained, reference.silhouette_length);
}

void check(const Limits& limits, const Reference& reference, Comparison& result) {
  const auto at_most = [&](std::string_view what, double value, double limit) {
    if (value <= limit) return;
    result.exceeded.push_back(fmt::format("{} {:.3g} > {:.3g}", what, value, limit));
  };
  at_most("mean", result.mean_unclassed, limits.mean);
  at_most("p99.9", result.p999_unclassed, limits.p999);
  at_most("p99.99", result.p9999_unclassed, limits.p9999);
  at_most("unexplained outliers", double(result.classes[std::size_t(PixelClass::kUnexplained)]),
          double(granted(limits, reference)));
}

void check_shares(const Reference& reference, const Allowances& allowances, Comparison& result) {
  long long total = 0;
  const auto add = [&](std::size_t allowance, long long count) {
    result.shares.push_back(
        class_share(allowance, count, result.covered, reference.silhouette_length, allowances));
  };
  for (std::size_t i = 0; i < std::size_t(PixelClass::kUnexplained); ++i) {
    if (result.classes[i] == 0) continue;
    add(i, result.classes[i]);
    if (!allowances.stated[i]) total += result.classes[i];  // else it has leave of its own
  }
  if (total > 0) add(kTotalAllowance, total);
}

/// With so many looked at, and more unexplained than is granted, the pictures differ, whatever the
/// rest are.
constexpr std::size_t kEnough = 256;

/// Calls look(i) for the indices below `count`, on all cores, in rounds that each spread over all
/// of them; stops after a round when `is_enough` holds. Returns how many were looked at.
template <class Look, class IsEnough>
std::size_t look_at(std::size_t count, const Look& look, const IsEnough& is_enough) {
  const std::size_t rounds = (count + kEnough - 1) / kEnough;
  std::size_t seen = 0;
  for (std::size_t first = 0; first < rounds && !(seen > 0 && is_enough()); ++first) {
    const std::size_t size = (count - first + rounds - 1) / rounds;
    oneapi::tbb::parallel_for(std::size_t{0}, size,
                              [&](std::size_t i) { look(first + i * rounds); });
    seen += size;
  }
  return seen;
}

PixelMark& mark_at(Comparison& result, PixelPlace place) {
  return result.marks.at(place.x, place.y);
}

/// Finds the classes of the pixels in `outliers`, indices of `pixels`, and counts them.
void classify(const Explainer& explainer, const Image& theirs, bool limited, const Limits& limits,
              long long allowed, const std::vector<std::size_t>& outliers,
              std::vector<PixelError>& pixels, Comparison& result) {
  std::atomic<long long> unexplained = 0;
  const auto look = [&](std::size_t i) {
    PixelError& pixel = pixels[outliers[i]];
    const Rgb& color = theirs.at(pixel.place.x, pixel.place.y).color;
    pixel.why = explainer.explain({pixel.place, color, limits.outlier, limits.edge, limited});
    if (pixel.why == PixelClass::kUnexplained) ++unexplained;
  };
  const std::size_t seen =
      look_at(outliers.size(), look, [&] { return unexplained.load() > allowed; });
  result.outliers = (long long)outliers.size();
  result.unsearched = result.outliers - (long long)seen;
  constexpr std::size_t kMaxPlaces = 10;
  for (const std::size_t i : outliers) {
    ++result.classes[std::size_t(*pixels[i].why)];
    mark_at(result, pixels[i].place) = PixelMark(1 + std::size_t(*pixels[i].why));
    if (pixels[i].why == PixelClass::kUnexplained && result.unexplained.size() < kMaxPlaces) {
      result.unexplained.push_back(pixels[i].place);
    }
  }
}

void count_coverage(const Reference& reference, const std::vector<PixelPlace>& places, double edge,
                    Comparison& result) {
  std::atomic<long long> explained = 0;
  std::atomic<long long> unexplained = 0;
  for (const PixelPlace& place : places) mark_at(result, place) = kCoverageMark;
  const auto look = [&](std::size_t i) {
    const bool is_explained = explains_coverage(reference, places[i], edge);
    if (is_explained) mark_at(result, places[i]) = kEdgeMark;
    ++(is_explained ? explained : unexplained);
  };
  look_at(places.size(), look, [&] { return unexplained.load() > 0; });
  result.coverage_differs = (long long)places.size();
  result.coverage_unexplained = result.coverage_differs - explained.load();
}

}  // namespace

Outcome Comparison::outcome() const {
  if (!exceeded.empty()) return Outcome::kDiffered;
  return std::ranges::any_of(shares, &ClassShare::exceeded) ? Outcome::kExplained
                                                            : Outcome::kAgreed;
}

Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, bool limited, const Limits& limits,
                   const Allowances& allowances) {
  Comparison result;
  result.marks = {theirs.width, theirs.height};
  std::vector<PixelError> pixels;
  std::vector<std::size_t> outliers;
  std::vector<PixelPlace> half_covered;
  result.has_no_coverage =
      std::ranges::none_of(theirs.pixels, [](const RgbaPixel& p) { return p.coverage > 0.5f; });
  for (int y = 0; y < theirs.height; ++y) {
    for (int x = 0; x < theirs.width; ++x) {
      const bool covered = ours.at(x, y).coverage > 0.5f;
      const RgbaPixel& their = theirs.at(x, y);
      result.covered += covered;
      const bool differs = covered != (their.coverage > 0.5f);
      if (differs) half_covered.push_back({x, y});
      if (!covered || (differs && !result.has_no_coverage)) continue;
      const double error = channel_error(to_vec(ours.at(x, y).color), their.color, limited);
      const bool is_outlier = !(error <= limits.outlier);
      if (is_outlier) outliers.push_back(pixels.size());
      pixels.push_back({error, {x, y}, reference.silhouettes.at(x, y) == 0, {}});
      if (is_outlier) pixels.back().why = PixelClass::kUnexplained;
    }
  }
  count_coverage(reference, half_covered, limits.edge, result);
  classify(Explainer(reference, shot), theirs, limited, limits, granted(limits, reference),
           outliers, pixels, result);
  summarise(std::move(pixels), result);
  check(limits, reference, result);
  check_shares(reference, allowances, result);
  return result;
}

}  // namespace lumaknot::validate
