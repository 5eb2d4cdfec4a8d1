#include "diagnosis/search.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lumaknot::diagnosis {
namespace {

constexpr double kExplained = 0.97;       // of the pixels, by one cause
constexpr double kExplainedByTwo = 0.95;  // by a pair, whose errors add up
constexpr double kMaxValue = 1.0;         // of the score above the floor
constexpr double kPerNumber = 0.006;      // the price of a number
constexpr double kSpecialBonus = 0.018;   // of a named special case
constexpr double kMinFall = 0.5;          // of the score above the floor, or nobody is accused
constexpr double kMatchingMasks = 0.002;  // of the pixels, at most: placement is not to blame
constexpr std::size_t kRefined = 8;       // hypotheses that are fitted to the end
constexpr std::size_t kRefinedPairs = 5;
constexpr std::size_t kFirstOfPairs = 3;

/// The score of a picture that is right but for how its values are stored.
double floor_of(Depth depth) {
  return depth == Depth::kEightBits ? 0.83 : 0;  // the mean of log(1 + max(e)^2), e uniform
}

double cost_of(const Explanation& e) {
  double cost = e.score.value;
  for (const Hypothesis* cause : e.causes) {
    cost += kPerNumber * double(cause->parameters.size()) - (cause->special ? kSpecialBonus : 0);
  }
  return cost;
}

double mask_mismatch(const Problem& problem, const Drawn& ours) {
  const Target& target = problem.target;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ours.coverage.size(); ++i) {
    if (std::abs(ours.coverage[i] - target.coverage[i]) <= 0.5) continue;
    const bool seen = largest_magnitude(ours.colors[i] - target.colors[i]) > 0.05;
    count += target.facts.has_alpha || seen;
  }
  return double(count) / double(problem.pixels);
}

std::vector<double> scene_values(const Hypothesis& h) {
  std::vector<double> values;
  for (const Parameter& p : h.parameters) values.push_back(p.start);
  return values;
}

class Search {
 public:
  Search(const Problem& problem, const std::vector<Hypothesis>& all)
      : problem_(problem), all_(all) {
    as_given_ = scored(problem, {});
    const Drawn ours = draw(problem, {});
    masks_match_ = mask_mismatch(problem, ours) < kMatchingMasks;
  }

  Found run() {
    Found found =
        best_of(screened({},
                         [&](const Hypothesis& h) {
                           return !h.costly && (h.rung == Rung::kPlacement) != masks_match_;
                         }),
                1);
    if (found.accepted.empty()) {
      merge(found, best_of(screened({}, [&](const Hypothesis& h) { return h.costly; }), 1));
    }
    if (found.accepted.empty()) merge(found, pairs());
    return found;
  }

 private:
  bool accepts(const Explanation& e) const {
    const double floor = floor_of(problem_.target.facts.depth);
    const double above = as_given_.score.value - floor, left = e.score.value - floor;
    const double share = e.causes.size() > 1 ? kExplainedByTwo : kExplained;
    return e.score.explained >= share && left < kMaxValue && above - left >= kMinFall * above;
  }

  /// `h` added to `first`, with the best of its starts, after a few steps.
  Explanation screen(const Explanation& first, const Hypothesis& h) const {
    std::vector<std::vector<double>> starts = h.starts;
    if (starts.empty()) starts.push_back(scene_values(h));
    const bool masks = h.rung == Rung::kPlacement && !masks_match_;
    std::vector<std::pair<double, Explanation>> tried;
    for (const std::vector<double>& start : starts) {
      Explanation e = first;
      insert(e, h, start);
      if (h.parameters.empty()) return scored(problem_, std::move(e));
      tried.emplace_back(starts.size() > 1 ? distance_of(e, masks) : 0, std::move(e));
    }
    std::ranges::stable_sort(tried, {}, [](const auto& t) { return t.first; });
    constexpr std::size_t kStarts = 3;
    std::optional<Explanation> best;
    for (std::size_t i = 0; i < std::min(kStarts, tried.size()); ++i) {
      Explanation e = fit_of(tried[i].second, h, masks);
      if (!best || e.score.value < best->score.value) best = std::move(e);
    }
    return *best;
  }

  double distance_of(const Explanation& e, bool masks) const {
    if (masks) return mask_distance(problem_, e);
    return scored(problem_.coarse ? *problem_.coarse : problem_, e).score.value;
  }

  Explanation fit_of(const Explanation& start, const Hypothesis& h, bool masks) const {
    constexpr int kScreenSteps = 3;
    if (!masks) return fitted(problem_, start, free_of(start, h), kScreenSteps);
    const Explanation by_mask = fitted(problem_, start, free_of(start, h), kScreenSteps, true);
    return fitted(problem_, by_mask, free_of(by_mask, h), kScreenSteps);
  }

  /// How many of the last causes must be free for `h` to be.
  static std::size_t free_of(const Explanation& e, const Hypothesis& h) {
    const auto at = std::ranges::find(e.causes, &h) - e.causes.begin();
    return e.causes.size() - std::size_t(at);
  }

  /// In the order of the rungs.
  static void insert(Explanation& e, const Hypothesis& h, std::vector<double> values) {
    std::size_t at = 0;
    while (at < e.causes.size() && e.causes[at]->rung <= h.rung) ++at;
    e.causes.insert(e.causes.begin() + std::ptrdiff_t(at), &h);
    e.values.insert(e.values.begin() + std::ptrdiff_t(at), std::move(values));
  }

  template <class Wanted>
  std::vector<Explanation> screened(const Explanation& first, Wanted wanted) const {
    std::vector<const Hypothesis*> chosen;
    for (const Hypothesis& h : all_) {
      if (std::ranges::count(first.causes, &h) == 0 && wanted(h)) chosen.push_back(&h);
    }
    std::vector<Explanation> tried(chosen.size());
    oneapi::tbb::parallel_for(std::size_t{0}, chosen.size(),
                              [&](std::size_t i) { tried[i] = screen(first, *chosen[i]); });
    return tried;
  }

  /// The best of `tried`, fitted to the end, sorted into accepted ones and the nearest.
  Found best_of(std::vector<Explanation> tried, std::size_t causes) const {
    std::ranges::stable_sort(tried, {}, cost_of);
    if (tried.size() > (causes > 1 ? kRefinedPairs : kRefined)) {
      tried.resize(causes > 1 ? kRefinedPairs : kRefined);
    }
    oneapi::tbb::parallel_for(std::size_t{0}, tried.size(), [&](std::size_t i) {
      constexpr int kSteps = 25;
      tried[i] = fitted(problem_, std::move(tried[i]), tried[i].causes.size(), kSteps);
    });
    std::ranges::stable_sort(tried, {}, cost_of);
    Found found;
    for (Explanation& e : tried) {
      if (accepts(e)) {
        found.accepted.push_back(std::move(e));
      } else if (!found.nearest) {
        found.nearest = std::move(e);
      }
    }
    return found;
  }

  static void merge(Found& found, Found more) {
    found.accepted = std::move(more.accepted);
    if (!found.nearest || (more.nearest && cost_of(*more.nearest) < cost_of(*found.nearest))) {
      if (more.nearest) found.nearest = std::move(more.nearest);
    }
  }

  /// Each of the best single causes together with every other.
  Found pairs() const {
    std::vector<Explanation> singles = screened({}, [&](const Hypothesis& h) {
      return !h.costly && (h.rung == Rung::kPlacement) != masks_match_;
    });
    std::ranges::stable_sort(singles, {}, cost_of);
    std::vector<Explanation> tried;
    for (std::size_t i = 0; i < std::min(kFirstOfPairs, singles.size()); ++i) {
      const Explanation first = fitted(problem_, singles[i], singles[i].causes.size(), 6);
      for (Explanation& e : screened(first, [&](const Hypothesis& h) {
             return !h.costly && (!masks_match_ || h.rung != Rung::kPlacement);
           })) {
        tried.push_back(std::move(e));
      }
    }
    return best_of(std::move(tried), 2);
  }

  const Problem& problem_;
  const std::vector<Hypothesis>& all_;
  Explanation as_given_;
  bool masks_match_ = true;
};

}  // namespace

Found search(const Problem& problem, const std::vector<Hypothesis>& hypotheses) {
  return Search(problem, hypotheses).run();
}

bool agrees(const Problem& problem, const Drawn& ours) {
  const Score score = score_of(problem.target, errors_of(problem.target, ours), problem.pixels);
  constexpr double kWithin = 0.997;
  return score.explained >= kWithin && mask_mismatch(problem, ours) < kMatchingMasks;
}

}  // namespace lumaknot::diagnosis
