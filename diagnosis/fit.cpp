#include "diagnosis/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/least_squares.h"

namespace lumaknot::diagnosis {
namespace {

using Values = std::vector<double>;

/// The scene changed by the causes.
Setup setup_of(const Problem& problem, const Explanation& explanation) {
  Setup setup = problem.setup;
  for (std::size_t i = 0; i < explanation.causes.size(); ++i) {
    explanation.causes[i]->apply(setup, explanation.values[i]);
  }
  return setup;
}

/// A grid of one number per pixel, blurred by three running means in each direction.
Values blurred(Values values, const PixelGrid& grid, int radius) {
  const auto line = [&](std::size_t first, std::size_t stride, int count) {
    Values sums(std::size_t(count) + 1, 0.0);
    for (int i = 0; i < count; ++i) {
      sums[std::size_t(i) + 1] = sums[std::size_t(i)] + values[first + std::size_t(i) * stride];
    }
    for (int i = 0; i < count; ++i) {
      const int low = std::max(0, i - radius), high = std::min(count, i + radius + 1);
      values[first + std::size_t(i) * stride] =
          (sums[std::size_t(high)] - sums[std::size_t(low)]) / (2 * radius + 1);
    }
  };
  const auto columns = std::size_t(grid.columns);
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < grid.rows; ++y) line(std::size_t(y) * columns, 1, grid.columns);
    for (int x = 0; x < grid.columns; ++x) line(std::size_t(x), columns, grid.rows);
  }
  return values;
}

/// What is compared: residuals, `channels` of them per pixel, and each pixel's error.
struct Residuals {
  std::size_t channels = 4;
  Values values;
  Values errors;
};

Residuals color_residuals(const Target& target, const Drawn& ours) {
  Residuals r{4, Values(4 * ours.colors.size()), errors_of(target, ours)};
  for (std::size_t i = 0; i < ours.colors.size(); ++i) {
    const Vec3d difference = ours.colors[i] - target.colors[i];
    r.values[4 * i] = difference.x;
    r.values[4 * i + 1] = difference.y;
    r.values[4 * i + 2] = difference.z;
    r.values[4 * i + 3] = target.facts.has_alpha ? ours.coverage[i] - target.coverage[i] : 0;
  }
  return r;
}

Residuals mask_residuals(const Target& target, const Values& coverage, int radius) {
  Residuals r{1, Values(coverage.size()), Values(coverage.size())};
  for (std::size_t i = 0; i < r.values.size(); ++i) {
    r.values[i] = coverage[i] - target.coverage[i];
  }
  r.values = blurred(std::move(r.values), target.grid, radius);
  for (std::size_t i = 0; i < r.values.size(); ++i) r.errors[i] = std::abs(r.values[i]);
  return r;
}

/// The scale above which an error counts less: what all but a share of the pixels keep below.
double robust_scale(const Residuals& r, double noise, std::size_t pixels, double share) {
  Values errors = r.errors;
  const std::size_t above = std::min(errors.size() - 1, std::size_t(share * double(pixels)));
  const auto at = errors.end() - 1 - std::ptrdiff_t(above);
  std::ranges::nth_element(errors, at);
  return std::max(noise, *at);
}

double robust_sum(const Residuals& r, double scale) {
  double sum = 0;
  for (const double error : r.errors) sum += std::log1p(error * error / (scale * scale));
  return std::isfinite(sum) ? sum : 1e300;
}

/// The shares that robust_scale() leaves out, one after the other. Half would be too much, as half
/// of a picture is often too flat to say where it is; and where all but a texture's edges fits,
/// only these say what is left.
constexpr std::array<double, 2> kOutliers{0.25, 0.03};

/// One place in the values of the free causes.
struct Unknown {
  std::size_t cause, parameter;
};

/// Of the blurs of masks, one after the other, pixels of the grid.
constexpr std::array<int, 3> kMaskRadii{6, 2, 1};

/// The part of a parameter's step from which derivatives are taken in the end.
constexpr double kMinShare = 1e-3;

/// The search for one explanation's numbers.
class Fit {
 public:
  Fit(const Problem& problem, Explanation start, std::size_t free, int mask_radius)
      : problem_(problem), best_(std::move(start)), mask_radius_(mask_radius) {
    for (std::size_t c = best_.causes.size() - free; c < best_.causes.size(); ++c) {
      for (std::size_t p = 0; p < best_.values[c].size(); ++p) unknowns_.push_back({c, p});
    }
  }

  bool has_unknowns() const { return !unknowns_.empty(); }

  Explanation run(int steps) {
    here_ = residuals(best_);
    // Masks are made of whole pixels: a smaller change is not seen in them.
    share_ = mask_radius_ > 0 ? problem_.target.grid.step : 0.1;
    const double min_share = mask_radius_ > 0 ? 0.1 : kMinShare;
    for (int step = 0; step < steps; ++step) {
      const bool better = improve();
      if (!better && share_ <= min_share) break;
      damping_ = better ? 0.3 * damping_ : kDamping;
      share_ = std::max(min_share, (better ? 0.3 : 0.1) * share_);
    }
    return std::move(best_);
  }

 private:
  static constexpr double kDamping = 1e-3;

  /// Takes a Gauss-Newton step, or a part of it, if that lowers the robust sum.
  bool improve() {
    const std::vector<Residuals> columns = derivatives(here_);
    return std::ranges::any_of(kOutliers, [&](double share) {
      return improve(columns, robust_scale(here_, floor(), problem_.pixels, share));
    });
  }

  bool improve(const std::vector<Residuals>& columns, double scale) {
    const Values move = direction(columns, scale);
    const double before = robust_sum(here_, scale);
    for (const double part : {1.0, 0.25}) {
      Explanation next = moved(move, part);
      Residuals there = residuals(next);
      if (robust_sum(there, scale) >= before * (1 - 1e-6)) continue;
      here_ = std::move(there);
      best_ = std::move(next);
      return true;
    }
    return false;
  }

  double floor() const { return mask_radius_ > 0 ? 0.5 : problem_.target.facts.noise; }

  const Parameter& parameter(const Unknown& u) const {
    return best_.causes[u.cause]->parameters[u.parameter];
  }

  Residuals residuals(const Explanation& e) const {
    if (mask_radius_ == 0) return color_residuals(problem_.target, draw(problem_, e));
    return mask_residuals(problem_.target, problem_.drawer.coverage(setup_of(problem_, e)),
                          mask_radius_);
  }

  /// The derivative by each unknown times its step, from a change of `share_` of its step.
  std::vector<Residuals> derivatives(const Residuals& here) const {
    std::vector<Residuals> columns;
    for (const Unknown& u : unknowns_) {
      Explanation changed = best_;
      double& value = changed.values[u.cause][u.parameter];
      const double by = value + share_ * parameter(u).step > parameter(u).max ? -share_ : share_;
      value += by * parameter(u).step;
      Residuals column = residuals(changed);
      for (std::size_t i = 0; i < column.values.size(); ++i) {
        column.values[i] = (column.values[i] - here.values[i]) / by;
      }
      columns.push_back(std::move(column));
    }
    return columns;
  }

  /// Whether a pixel of colours is covered for one value and not for another: its slope says
  /// nothing then.
  bool is_outline(const std::vector<Residuals>& columns, std::size_t i) const {
    if (mask_radius_ > 0) return false;
    constexpr std::size_t kCoverage = 3;
    return std::ranges::any_of(columns, [&](const Residuals& r) {
      return share_ * std::abs(r.values[r.channels * i + kCoverage]) > 0.5;
    });
  }

  /// The Gauss-Newton step, in steps of the parameters.
  Values direction(const std::vector<Residuals>& columns, double scale) const {
    const std::size_t n = columns.size();
    Values a(n * n, 0.0), b(n, 0.0);
    for (std::size_t i = 0; i < here_.errors.size(); ++i) {
      if (is_outline(columns, i)) continue;
      const double ratio = here_.errors[i] / scale;
      const double weight = 1 / (1 + ratio * ratio);
      for (std::size_t c = here_.channels * i; c < here_.channels * (i + 1); ++c) {
        for (std::size_t j = 0; j < n; ++j) {
          const double weighted = weight * columns[j].values[c];
          b[j] -= weighted * here_.values[c];
          for (std::size_t k = 0; k <= j; ++k) a[j * n + k] += weighted * columns[k].values[c];
        }
      }
    }
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) a[j * n + k] = a[k * n + j];
    }
    return solve(std::move(a), std::move(b), damping_);
  }

  Explanation moved(const Values& move, double part) const {
    Explanation next = best_;
    for (std::size_t j = 0; j < unknowns_.size(); ++j) {
      const Parameter& p = parameter(unknowns_[j]);
      double& value = next.values[unknowns_[j].cause][unknowns_[j].parameter];
      value = std::clamp(value + part * move[j] * p.step, p.min, p.max);
    }
    return next;
  }

  const Problem& problem_;
  Explanation best_;
  int mask_radius_;  ///< of masks' blur, pixels of the grid; 0: colours are compared
  std::vector<Unknown> unknowns_;
  Residuals here_;  ///< of best_
  double damping_ = kDamping;
  double share_ = 0.1;  ///< of a parameter's step, from which derivatives are taken
};

}  // namespace

Drawn draw(const Problem& problem, const Explanation& explanation) {
  Drawn ours = problem.drawer.draw(setup_of(problem, explanation));
  show_like(problem.target, ours);
  return ours;
}

Explanation scored(const Problem& problem, Explanation explanation) {
  const Drawn ours = draw(problem, explanation);
  explanation.score = score_of(problem.target, errors_of(problem.target, ours), problem.pixels);
  return explanation;
}

double mask_distance(const Problem& problem, const Explanation& explanation) {
  const Values coverage = problem.drawer.coverage(setup_of(problem, explanation));
  double sum = 0;
  for (const double error : mask_residuals(problem.target, coverage, kMaskRadii[0]).errors) {
    sum += error * error;
  }
  return sum;
}

Explanation searched_around(const Problem& problem, Explanation best) {
  constexpr int kSteps = 6;
  for (int step = 0; step < kSteps; ++step) {
    const double share = std::ldexp(1, -step);
    for (std::size_t c = 0; c < best.causes.size(); ++c) {
      for (std::size_t p = 0; p < best.values[c].size(); ++p) {
        const Parameter& parameter = best.causes[c]->parameters[p];
        for (const double by : {share, -share}) {
          Explanation next = best;
          double& value = next.values[c][p];
          value = std::clamp(value + by * parameter.step, parameter.min, parameter.max);
          next = scored(problem, std::move(next));
          if (next.score.value < best.score.value) best = std::move(next);
        }
      }
    }
  }
  return best;
}

Explanation fitted(const Problem& problem, Explanation explanation, std::size_t free, int steps,
                   bool masks) {
  const std::vector<int> radii =
      masks ? std::vector<int>(kMaskRadii.begin(), kMaskRadii.end()) : std::vector<int>{0};
  for (const int radius : radii) {
    Fit fit(problem, std::move(explanation), free, radius);
    explanation = fit.has_unknowns() ? fit.run(steps) : fit.run(0);
  }
  return scored(problem, std::move(explanation));
}

}  // namespace lumaknot::diagnosis
