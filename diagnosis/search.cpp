#include "diagnosis/search.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "system/known.h"

namespace lumaknot::diagnosis {
namespace {

constexpr double kExplained = 0.97;         // of the pixels, by one cause
constexpr double kExplainedByTwo = 0.985;   // by a pair, which fits more by chance
constexpr double kMaxValue = 1.0;           // of the score above the floor
constexpr double kPerNumber = 0.006;        // the price of a number
constexpr double kSpecialBonus = 0.018;     // of a named special case
constexpr double kMinFall = 0.5;            // of the score above the floor, or nobody is accused
constexpr double kMatchingMasks = 0.002;    // of the pixels, at most: placement is not to blame
constexpr int kMaskSteps = 6;               // of a fit of masks
constexpr std::size_t kRefined = 8;         // hypotheses that are fitted to the end
constexpr std::size_t kSearchedAround = 3;  // of them, where a gradient is lost
constexpr std::size_t kStarts = 3;          // of each, that are followed
constexpr std::size_t kFirstOfPairs = 8;    // single causes that others are added to
constexpr std::size_t kFollowedPairs = 100;
constexpr std::size_t kPromisingPairs = 16;
constexpr std::size_t kRefinedPairs = 5;

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
  values.reserve(h.parameters.size());
  for (const Parameter& p : h.parameters) values.push_back(p.start);
  return values;
}

class Search {
 public:
  Search(const Problem& problem, const std::vector<Hypothesis>& all, const Progress& progress)
      : progress_(progress),
        problem_(problem),
        screening_(problem.coarse ? *problem.coarse : problem),
        all_(all) {
    as_given_ = scored(problem, {});
    const Drawn ours = draw(problem, {});
    masks_match_ = mask_mismatch(problem, ours) < kMatchingMasks;
  }

  Found singles() {
    std::vector<Explanation> all = screened({}, kStarts, [&](const Hypothesis& h) {
      return !h.costly && (h.rung == Rung::kPlacement) != masks_match_;
    });
    report(0.1);
    Found found = best_of(promising(all), kRefined);
    found.screened = std::move(all);
    report(0.2);
    if (!found.accepted.empty()) return found;
    std::vector<Explanation> costly =
        screened({}, kStarts, [](const Hypothesis& h) { return h.costly; });
    if (is_small()) found.screened.push_back(*std::ranges::min_element(costly, {}, cost_of));
    return with(std::move(found), best_of(std::move(costly), kRefined));
  }

  Found pairs(const Found& singles) {
    report(0.4);
    return with(singles,
                without_needless(best_of(promising_pairs(singles.screened), kRefinedPairs)));
  }

 private:
  /// About the share of the work that is done if all of it is needed.
  void report(double share) const {
    if (progress_) progress_(share);
  }

  bool accepts(const Explanation& e) const {
    const double floor = floor_of(problem_.target.facts.depth);
    const double above = as_given_.score.value - floor, left = e.score.value - floor;
    const double share = e.causes.size() > 1 ? kExplainedByTwo : kExplained;
    return e.score.explained >= share && left < kMaxValue && above - left >= kMinFall * above;
  }

  /// `h` added to `first`, with the best of its starts, after a few steps on few pixels.
  Explanation screen(const Explanation& first, const Hypothesis& h, std::size_t max_starts) const {
    const bool masks = h.rung == Rung::kPlacement && !masks_match_;
    std::vector<std::pair<double, Explanation>> tried;
    for (const std::vector<double>& start : starts_of(h)) {
      Explanation e = first;
      insert(e, h, start);
      if (h.parameters.empty() && first.causes.empty()) return scored(screening_, std::move(e));
      tried.emplace_back(h.starts.size() > 1 ? distance_of(e, masks) : 0, std::move(e));
    }
    std::ranges::stable_sort(tried, {}, [](const auto& t) { return t.first; });
    std::optional<Explanation> best;
    for (std::size_t i = 0; i < std::min(max_starts, tried.size()); ++i) {
      Explanation e = fit_of(tried[i].second, h, masks);
      if (!best || e.score.value < best->score.value) best = std::move(e);
    }
    return known(std::move(best));
  }

  /// Those nearest to the scene first, so that they win where several are as good.
  static std::vector<std::vector<double>> starts_of(const Hypothesis& h) {
    const std::vector<double> own = scene_values(h);
    if (h.starts.empty()) return {own};
    std::vector<std::vector<double>> starts = h.starts;
    std::ranges::stable_sort(starts, {}, [&](const std::vector<double>& start) {
      double distance = 0;
      for (std::size_t i = 0; i < own.size(); ++i) distance += std::abs(start[i] - own[i]);
      return distance;
    });
    return starts;
  }

  double distance_of(const Explanation& e, bool masks) const {
    if (!masks) return scored(screening_, e).score.value;
    // A fifth more or less says little: symmetric meshes look alike from several sides.
    return std::round(std::log(mask_distance(screening_, e) + 1e-9) * 5);
  }

  Explanation fit_of(const Explanation& start, const Hypothesis& h, bool masks) const {
    constexpr int kScreenSteps = 3, kJointSteps = 2;
    if (!masks) {
      const bool alone = start.causes.size() == 1;
      return fitted(screening_, start, start.causes.size(), alone ? kScreenSteps : kJointSteps);
    }
    const Explanation by_mask = fitted(screening_, start, free_of(start, h), kMaskSteps, true);
    return fitted(screening_, by_mask, free_of(by_mask, h), kScreenSteps);
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
  std::vector<Explanation> screened(const Explanation& first, std::size_t max_starts,
                                    Wanted wanted) const {
    std::vector<const Hypothesis*> chosen;
    for (const Hypothesis& h : all_) {
      if (std::ranges::count(first.causes, &h) == 0 && wanted(h)) chosen.push_back(&h);
    }
    std::vector<Explanation> tried(chosen.size());
    oneapi::tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) {
      tried[i] = screen(first, *chosen[i], max_starts);
    });
    return tried;
  }

  /// The `count` best of `tried`, fitted by some more steps.
  static std::vector<Explanation> fitted_best(const Problem& problem,
                                              std::vector<Explanation> tried, std::size_t count,
                                              int steps) {
    std::ranges::stable_sort(tried, {}, cost_of);
    tried.resize(std::min(tried.size(), count));
    oneapi::tbb::parallel_for(std::size_t{0}, tried.size(), [&](std::size_t i) {
      const std::size_t free = tried[i].causes.size();
      tried[i] = fitted(problem, std::move(tried[i]), free, steps);
    });
    return tried;
  }

  /// The `count` best of `tried`, fitted on all pixels.
  std::vector<Explanation> refined(std::vector<Explanation> tried, std::size_t count,
                                   int steps) const {
    std::ranges::stable_sort(tried, {}, cost_of);
    tried.resize(std::min(tried.size(), count));
    oneapi::tbb::parallel_for(std::size_t{0}, tried.size(), [&](std::size_t i) {
      const std::size_t free = tried[i].causes.size();
      const bool places = tried[i].causes.front()->rung == Rung::kPlacement;
      if (places && !masks_match_) {
        tried[i] = fitted(problem_, std::move(tried[i]), free, kMaskSteps, true);
      }
      tried[i] = fitted(problem_, std::move(tried[i]), free, steps);
      if (tried[i].score.explained > kExplained || i >= kSearchedAround) return;
      tried[i] = searched_around(problem_, std::move(tried[i]));
      tried[i] = fitted(problem_, std::move(tried[i]), free, steps);
    });
    std::ranges::stable_sort(tried, {}, cost_of);
    return tried;
  }

  /// The same cause with numbers nearer to the scene's, where they explain as much: a mesh with
  /// equal parts looks alike from several sides.
  Explanation nearer_to_scene(Explanation e, int steps) const {
    constexpr double kAsGood = 0.01;
    if (e.causes.size() != 1 || e.causes.front()->starts.size() < 2) return e;
    const Hypothesis& h = *e.causes.front();
    const bool masks = h.rung == Rung::kPlacement && !masks_match_;
    const std::vector<std::vector<double>> starts = starts_of(h);
    for (std::size_t i = 0; i < std::min(kStarts, starts.size()); ++i) {
      Explanation near = fit_of({e.causes, {starts[i]}, {}}, h, masks);
      near = fitted(problem_, std::move(near), 1, steps);
      if (near.score.value < e.score.value + kAsGood) return near;
    }
    return e;
  }

  /// The best of `tried`, fitted to the end, sorted into accepted ones and the nearest.
  Found best_of(std::vector<Explanation> tried, std::size_t count) const {
    constexpr int kSteps = 25;
    Found found;
    for (Explanation& e : refined(std::move(tried), count, kSteps)) {
      if (accepts(e)) {
        found.accepted.push_back(nearer_to_scene(std::move(e), kSteps));
      } else if (!found.nearest) {
        found.nearest = std::move(e);
      }
    }
    return found;
  }

  /// The best by score and, as far as masks say, by mask.
  std::vector<Explanation> promising(std::vector<Explanation> singles) const {
    std::ranges::stable_sort(singles, {}, cost_of);
    if (masks_match_ || singles.size() <= kRefined) return singles;
    constexpr std::size_t kByScore = kRefined / 2;
    std::ranges::stable_sort(singles.begin() + kByScore, singles.end(), {},
                             [&](const Explanation& e) { return mask_distance(screening_, e); });
    singles.resize(kRefined);
    return singles;
  }

  /// Single causes where one of a pair explains the picture alone, once it has a better start.
  Found without_needless(Found found) const {
    std::vector<Explanation> alone;
    for (const Explanation& pair : found.accepted) {
      for (std::size_t i = 0; i < 2; ++i) alone.push_back({{pair.causes[i]}, {pair.values[i]}, {}});
    }
    for (Explanation& e : alone) e = scored(problem_, std::move(e));
    Found single = best_of(std::move(alone), kRefined);
    if (!single.accepted.empty()) found.accepted = std::move(single.accepted);
    return found;
  }

  /// What a later search found where `found` accepted nothing.
  static Found with(Found found, Found more) {
    found.accepted = std::move(more.accepted);
    if (!found.nearest || (more.nearest && cost_of(*more.nearest) < cost_of(*found.nearest))) {
      if (more.nearest) found.nearest = std::move(more.nearest);
    }
    return found;
  }

  /// The most promising of the best single causes together with every other.
  std::vector<Explanation> promising_pairs(std::vector<Explanation> singles) const {
    constexpr int kFollowSteps = 4, kSteps = 6;
    std::ranges::stable_sort(singles, {}, [&](const Explanation& e) {
      return masks_match_ ? cost_of(e) : mask_distance(screening_, e);
    });
    std::vector<Explanation> tried;
    for (std::size_t i = 0; i < std::min(kFirstOfPairs, singles.size()); ++i) {
      for (Explanation& e : screened(singles[i], 1, [&](const Hypothesis& h) {
             return !h.costly && (h.rung != Rung::kPlacement || (!masks_match_ && i < 2));
           })) {
        tried.push_back(std::move(e));
      }
    }
    tried = fitted_best(screening_, std::move(tried), kFollowedPairs, kFollowSteps);
    return refined(std::move(tried), kPromisingPairs, kSteps);
  }

  /// Whether its finished picture is drawn fast enough to try it with every other cause.
  bool is_small() const {
    constexpr long long kMaxFinished = 32'000;
    const PixelGrid& grid = problem_.target.grid;
    return 1LL * grid.width * grid.height <= kMaxFinished;
  }

  const Progress& progress_;
  const Problem& problem_;
  const Problem& screening_;  ///< few pixels
  const std::vector<Hypothesis>& all_;
  Explanation as_given_;
  bool masks_match_ = true;
};

}  // namespace

Found search_singles(const Problem& problem, const std::vector<Hypothesis>& hypotheses,
                     const Progress& progress) {
  return Search(problem, hypotheses, progress).singles();
}

Found search_pairs(const Problem& problem, const std::vector<Hypothesis>& hypotheses,
                   const Found& singles, const Progress& progress) {
  return Search(problem, hypotheses, progress).pairs(singles);
}

bool agrees(const Problem& problem, const Drawn& ours) {
  const Score score = score_of(problem.target, errors_of(problem.target, ours), problem.pixels);
  constexpr double kWithin = 0.997;
  return score.explained >= kWithin && mask_mismatch(problem, ours) < kMatchingMasks;
}

}  // namespace lumaknot::diagnosis
