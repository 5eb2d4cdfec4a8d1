#include "validate/compare/images.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "validate/compare/pixel_error.h"
#include "validate/compare/quantile.h"

namespace lumaknot::validate {
namespace {

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

/// How much of their limits the pixels inside use that are in no class.
void summarise_use(const std::vector<PixelError>& pixels, LimitUse& use) {
  std::vector<double> ratios;
  for (const PixelError& p : pixels) {
    if (!p.inside || p.classed()) continue;
    ratios.push_back(p.ratio());
    if (p.ratio() > use.max) use.max = p.ratio(), use.worst = p.place, use.error = p.error;
  }
  use.p50 = quantile(ratios, 0.5);
  use.p99 = quantile(ratios, 0.99);
  use.p999 = quantile(ratios, 0.999);
}

/// The unexplained pixels that a renderer is granted.
long long granted(const Standard& standard, const Reference& reference) {
  return count_within(standard.promise.unexplained, reference.silhouette_length);
}

void check(const Standard& standard, const Reference& reference, Comparison& result) {
  const auto at_most = [&](std::string_view what, double value, std::optional<double> limit) {
    if (!limit || value <= *limit) return;
    result.exceeded.push_back(fmt::format("{} {:.3g} > {:.3g}", what, value, *limit));
  };
  at_most("mean", result.mean_unclassed, standard.limits.mean);
  at_most("p99.9", result.p999_unclassed, standard.limits.p999);
  at_most("unexplained outliers", double(result.classes[std::size_t(PixelClass::kUnexplained)]),
          double(granted(standard, reference)));
  // A shift counts where it accounts for most of the difference.
  const Shift& shift = result.shift;
  if (shift.explained > 0.5 && shift.size() > result.shift_limit + 4 * shift.deviation) {
    result.exceeded.push_back(fmt::format("shifted by ({:.2g}, {:.2g}) pixel, beyond {:.2g}",
                                          shift.x, shift.y, result.shift_limit));
  }
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
constexpr std::size_t kEnough = 128;

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

/// Compares one pair of images.
class Comparer {
 public:
  Comparer(const Reference& reference, const Shot& shot, const Image& ours, const Image& theirs,
           const Grid<Sensitivity>& sensitivities, const Standard& standard)
      : reference_(reference),
        shot_(shot),
        ours_(ours),
        theirs_(theirs),
        sensitivities_(sensitivities),
        standard_(standard) {}

  Comparison compare() {
    result_.marks = {theirs_.width, theirs_.height};
    result_.has_no_coverage =
        std::ranges::none_of(theirs_.pixels, [](const RgbaPixel& p) { return p.coverage > 0.5f; });
    for (int y = 0; y < theirs_.height; ++y) {
      for (int x = 0; x < theirs_.width; ++x) collect({x, y});
    }
    count_coverage();
    classify();
    result_.shift = fitted_shift(pixels_);
    summarise_use(pixels_, result_.use);
    if (!standard_.limits.max) result_.use.limit = parts_at(result_.use.worst);
    result_.shift_limit = shift_limit();
    summarise(std::move(pixels_), result_);
    check(standard_, reference_, result_);
    check_shares(reference_, standard_.allowances, result_);
    return std::move(result_);
  }

 private:
  const Sensitivity& sensitivity_at(PixelPlace place) const {
    static constexpr Sensitivity kNone;  // of tests and of limits that the user states
    return sensitivities_.pixels.empty() ? kNone : sensitivities_.at(place.x, place.y);
  }
  LimitParts parts_at(PixelPlace place) const {
    return limit_of(sensitivity_at(place), standard_.promise, standard_.output_steps);
  }
  PixelMark& mark_at(PixelPlace place) { return result_.marks.at(place.x, place.y); }
  double edge_at(PixelPlace place) const {
    return edge_distance(sensitivity_at(place), standard_.promise);
  }

  void collect(PixelPlace place) {
    const RgbaPixel &mine = ours_.at(place.x, place.y), &their = theirs_.at(place.x, place.y);
    const bool covered = mine.coverage > 0.5f;
    const bool differs = covered != (their.coverage > 0.5f);
    result_.covered += covered;
    if (differs) half_covered_.push_back(place);
    if (!covered || (differs && !result_.has_no_coverage)) return;
    PixelError pixel = pixel_error(place, mine.color, their.color);
    if (!(pixel.error <= pixel.limit)) {
      pixel.why = PixelClass::kUnexplained;
      outliers_.push_back(pixels_.size());
    }
    pixels_.push_back(pixel);
  }

  PixelError pixel_error(PixelPlace place, const Rgb& mine, const Rgb& their) const {
    const auto shown = [&](float v) {
      return double(standard_.limited ? std::clamp(v, 0.0f, 1.0f) : v);
    };
    const Sensitivity& s = sensitivity_at(place);
    const std::array<float, 3> a{mine.r, mine.g, mine.b}, b{their.r, their.g, their.b};
    PixelError pixel;
    pixel.place = place;
    pixel.error = channel_error(to_vec(mine), their, standard_.limited);
    pixel.limit = standard_.limits.max ? *standard_.limits.max : parts_at(place).sum();
    pixel.signed_error = shown(b[s.channel]) - shown(a[s.channel]);
    pixel.slope_x = s.slope_x;
    pixel.slope_y = s.slope_y;
    pixel.inside = reference_.silhouettes.at(place.x, place.y) == 0;
    return pixel;
  }

  /// The limit of an outlier: a normal that faces away is in the dark until it is turned, and has
  /// no errors there.
  double tolerance_of(const PixelError& pixel) const {
    const Fragment& fragment = reference_.fragments.at(pixel.place.x, pixel.place.y);
    if (standard_.limits.max || !faces_away(reference_.scene, fragment)) return pixel.limit;
    Fragment turned = fragment;
    turned.normal = -turned.normal;
    const Sensitivity sensitivity = sensitivity_of(reference_, shot_, turned, pixel.place);
    const LimitParts parts = limit_of(sensitivity, standard_.promise, standard_.output_steps);
    return std::max(pixel.limit, parts.sum());
  }

  /// Finds the classes of the outliers, and counts them.
  void classify() {
    const Explainer explainer(reference_, shot_);
    std::atomic<long long> unexplained = 0;
    const auto look = [&](std::size_t i) {
      PixelError& pixel = pixels_[outliers_[i]];
      const Rgb& color = theirs_.at(pixel.place.x, pixel.place.y).color;
      pixel.why = explainer.explain(
          {pixel.place, color, tolerance_of(pixel), edge_at(pixel.place), standard_.limited});
      if (pixel.why == PixelClass::kUnexplained) ++unexplained;
    };
    const long long allowed = granted(standard_, reference_);
    const std::size_t seen =
        look_at(outliers_.size(), look, [&] { return unexplained.load() > allowed; });
    result_.outliers = (long long)outliers_.size();
    result_.unsearched = result_.outliers - (long long)seen;
    constexpr std::size_t kMaxPlaces = 10;
    for (const std::size_t i : outliers_) {
      const auto why = std::size_t(pixels_[i].why.value_or(PixelClass::kUnexplained));
      ++result_.classes[why];
      mark_at(pixels_[i].place) = PixelMark(1 + why);
      if (!pixels_[i].classed() && result_.unexplained.size() < kMaxPlaces) {
        result_.unexplained.push_back(pixels_[i].place);
      }
    }
  }

  void count_coverage() {
    std::atomic<long long> explained = 0;
    std::atomic<long long> unexplained = 0;
    for (const PixelPlace& place : half_covered_) mark_at(place) = kCoverageMark;
    const auto look = [&](std::size_t i) {
      const PixelPlace& place = half_covered_[i];
      const bool is_explained = explains_coverage(reference_, place, edge_at(place));
      if (is_explained) mark_at(place) = kEdgeMark;
      ++(is_explained ? explained : unexplained);
    };
    look_at(half_covered_.size(), look, [&] { return unexplained.load() > 0; });
    result_.coverage_differs = (long long)half_covered_.size();
    result_.coverage_unexplained = result_.coverage_differs - explained.load();
  }

  /// Roundings may move all samples alike, a grid those of few triangles.
  double shift_limit() const {
    double most = 0;
    for (const PixelError& p : pixels_) {
      most = std::max(most, sample_error(sensitivity_at(p.place), standard_.promise));
    }
    return most + (standard_.promise.snaps_shade ? std::exp2(-standard_.promise.grid_bits - 2) : 0);
  }

  const Reference& reference_;
  const Shot& shot_;
  const Image &ours_, &theirs_;
  const Grid<Sensitivity>& sensitivities_;
  const Standard& standard_;
  std::vector<PixelError> pixels_;
  std::vector<std::size_t> outliers_;  ///< indices of pixels_
  std::vector<PixelPlace> half_covered_;
  Comparison result_;
};

}  // namespace

Outcome Comparison::outcome() const {
  if (!exceeded.empty()) return Outcome::kDiffered;
  return std::ranges::any_of(shares, &ClassShare::exceeded) ? Outcome::kExplained
                                                            : Outcome::kAgreed;
}

Comparison compare(const Reference& reference, const Shot& shot, const Image& ours,
                   const Image& theirs, const Grid<Sensitivity>& sensitivities,
                   const Standard& standard) {
  return Comparer(reference, shot, ours, theirs, sensitivities, standard).compare();
}

std::vector<std::string> classed_causes(const Comparison& comparison) {
  struct Classed {
    std::string_view pixels, cause;
  };
  constexpr std::array<Classed, 2> kClassed{
      {{"turned normal", "normals-turned"}, {"gated highlight", "highlights-gated"}}};
  std::vector<std::string> causes;
  for (const Classed& c : kClassed) {
    const auto at = std::ranges::find(kPixelClassNames, c.pixels) - kPixelClassNames.begin();
    if (comparison.classes[std::size_t(at)] > 0) causes.emplace_back(c.cause);
  }
  return causes;
}

}  // namespace lumaknot::validate
