#include "study/plan/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lumaknot::plan {
namespace {

constexpr double kClearly = 1.05;    // slower by this factor counts as slower
constexpr double kContender = 1.15;  // times within this factor of the best get more rounds
constexpr int kFirst = 2;            // rounds for all
constexpr int kBetter = 3;           // times the rounds
constexpr std::size_t kNeighbours = 2;

void report(const Progress& progress, double done) {
  if (progress) progress(std::min(done, 1.0));
}

/// The search of one method's grids.
class Rungs {
 public:
  Rungs(const measure::Method& method, std::span<const measure::GridSize> ladder, Trials& trials)
      : method_(method), ladder_(ladder), trials_(trials) {}

  measure::Method at(std::size_t rung) const { return measure::with_grid(method_, ladder_[rung]); }
  bool meets(std::size_t rung) { return trials_.result(at(rung)).met; }
  bool fails_by_far(std::size_t rung) { return trials_.result(at(rung)).misses_by_far(); }

  /// The coarsest that meets the tolerance, starting at `guess`. Errors need not fall from rung to
  /// rung: below the one found all are tried until two fail by far.
  std::optional<std::size_t> coarsest(std::size_t guess) {
    std::optional<std::size_t> good = first_from(guess);
    if (!good) return {};
    std::size_t high = *good;
    long low = below(high);
    while (long(high) - low > 1) {
      const std::size_t middle = std::size_t((long(high) + low) / 2);
      if (meets(middle)) {
        high = middle;
      } else {
        low = long(middle);
      }
    }
    return scan_below(high);
  }

 private:
  std::size_t scan_below(std::size_t good) {
    int far = 0;
    for (std::size_t rung = good; rung-- > 0 && far < 2;) {
      if (meets(rung)) good = rung;
      far = fails_by_far(rung) ? far + 1 : 0;
    }
    return good;
  }

  /// One that meets it at `guess` or farther up, in growing steps; empty if both that and the
  /// finest grid fail by far, as with a wrong filter or too few samples.
  std::optional<std::size_t> first_from(std::size_t guess) {
    if (fails_by_far(guess) && fails_by_far(ladder_.size() - 1)) return {};
    for (std::size_t step = 1, rung = guess;; rung += step, step *= 2) {
      const std::size_t tried = std::min(rung, ladder_.size() - 1);
      if (meets(tried)) return tried;
      if (tried + 1 == ladder_.size()) return {};
    }
  }

  /// The nearest below `high` that doesn't meet it, in growing steps; -1 if all that were tried
  /// meet it.
  long below(std::size_t& high) {
    for (long step = 1;; step *= 2) {
      const long rung = long(high) - step;
      if (rung < 0) return high > 0 && !meets(0) ? 0 : -1;
      if (!meets(std::size_t(rung))) return rung;
      high = std::size_t(rung);
    }
  }

  measure::Method method_;
  std::span<const measure::GridSize> ladder_;
  Trials& trials_;
};

std::optional<measure::Method> fastest(std::span<const measure::Method> methods, Trials& trials) {
  std::optional<measure::Method> best;
  for (const measure::Method& m : methods) {
    if (!best || trials.ratio(m) < trials.ratio(*best)) best = m;
  }
  return best;
}

/// Those within `share` of the fastest.
std::vector<measure::Method> contenders(std::span<const measure::Method> methods, double share,
                                        Trials& trials) {
  const std::optional<measure::Method> best = fastest(methods, trials);
  std::vector<measure::Method> near;
  if (!best) return near;
  for (const measure::Method& m : methods) {
    if (trials.min_ratio(m) <= share * trials.ratio(*best)) near.push_back(m);
  }
  return near;
}

/// A few rounds for every method, more for contenders, and more still for the closest of them.
void time_well(std::span<const measure::Method> methods, Trials& trials, int rounds) {
  if (methods.empty()) return;
  trials.time(methods, kFirst);
  trials.time(contenders(methods, 1.5, trials), rounds);
  trials.time(contenders(methods, kContender, trials), kBetter * rounds);
}

/// The first rung for which the prediction guarantees the tolerance; if none, the first whose place
/// it guarantees. The effect of the texture's filter is left to measuring.
std::size_t guessed_rung(const measure::Method& method, std::span<const measure::GridSize> ladder,
                         const Predictor& predictor) {
  const auto first = [&](auto promised) {
    std::size_t rung = 0;
    while (rung + 1 < ladder.size() &&
           !promised(predictor.of(measure::with_grid(method, ladder[rung])))) {
      ++rung;
    }
    return rung;
  };
  const Tolerance& tolerance = predictor.tolerance();
  const std::size_t whole = first([&](PredictedError error) {
    error.filter = 0;
    return error.promises(tolerance, 0);
  });
  if (whole + 1 < ladder.size()) return whole;
  return first([&](const PredictedError& error) { return error.place <= tolerance.shift; });
}

std::vector<measure::Method> on_coarsest(const Candidates& candidates) {
  std::vector<measure::Method> coarse;
  coarse.reserve(candidates.methods.size());
  for (const measure::Method& method : candidates.methods)
    coarse.push_back(measure::with_grid(method, candidates.ladder.front()));
  return coarse;
}

/// Whether `quicker` is the same method in double with fewer samples. Each sample is shaded: with
/// four times as many a frame takes nearly four times as long, and timing it takes long.
bool is_quicker(const measure::Method& quicker, const measure::Method& method) {
  measure::Method same = method;
  same.samples = quicker.samples;
  return method.number == measure::Number::kDouble && quicker == same &&
         quicker.samples < method.samples;
}

/// Takes out of `methods` all except those that are others with more samples.
std::vector<measure::Method> take_quickest(std::vector<measure::Method>& methods) {
  std::vector<measure::Method> quickest, slower;
  for (const measure::Method& method : methods) {
    const auto quicker = [&](const measure::Method& m) { return is_quicker(m, method); };
    (std::ranges::any_of(methods, quicker) ? slower : quickest).push_back(method);
  }
  methods = std::move(slower);
  return quickest;
}

/// The search of all methods.
class MethodSearch {
 public:
  MethodSearch(const Candidates& candidates, const Predictor& predictor, Trials& trials)
      : choices_(candidates), predictor_(predictor), trials_(trials) {}

  /// Searches those of `methods` that are fast enough on their coarsest grid, the fastest first.
  void search(std::vector<measure::Method> methods, const Progress& progress) {
    trials_.time(methods, kFirst);
    std::ranges::stable_sort(methods, {},
                             [&](const measure::Method& m) { return trials_.min_ratio(m); });
    double done = 0;
    for (const measure::Method& method : methods) {
      report(progress, 0.8 * done++ / double(methods.size()));
      if (!is_too_slow(method)) search(method);
    }
  }

  /// Those of `methods`, none of them searched or timed, that may be fast enough although they have
  /// more samples than others: four times as many take at least twice as long.
  std::vector<measure::Method> fast_enough(std::vector<measure::Method> methods,
                                           std::span<const measure::Method> all) {
    std::erase_if(methods, [&](const measure::Method& method) {
      return std::ranges::any_of(all, [&](const measure::Method& quicker) {
        return is_quicker(quicker, method) &&
               is_too_slow(quicker, std::sqrt(double(method.samples) / quicker.samples));
      });
    });
    return methods;
  }

  std::span<const measure::Method> finalists() const { return finalists_; }

 private:
  /// Whether the best so far is faster than this many times the method's time on its coarsest grid.
  bool is_too_slow(const measure::Method& method, double times = 1) {
    const std::optional<measure::Method> best = fastest(finalists_, trials_);
    return best && times * trials_.min_ratio(method) > kClearly * trials_.ratio(*best);
  }

  void search(const measure::Method& method) {
    Rungs rungs(method, choices_.ladder, trials_);
    const auto found = rungs.coarsest(guessed_rung(method, choices_.ladder, predictor_));
    if (!found) return;
    const std::size_t last = std::min(*found + kNeighbours, choices_.ladder.size() - 1);
    for (std::size_t rung = *found; rung <= last; ++rung) {
      if (rungs.meets(rung)) finalists_.push_back(rungs.at(rung));
    }
    trials_.time(finalists_, kFirst);
  }

  const Candidates& choices_;
  const Predictor& predictor_;
  Trials& trials_;
  std::vector<measure::Method> finalists_;
};

}  // namespace

std::optional<measure::Method> fastest_that_meets(const Candidates& candidates,
                                                  const Predictor& predictor, Trials& trials,
                                                  int rounds, const Progress& progress) {
  const std::vector<measure::Method> all = on_coarsest(candidates);
  MethodSearch search(candidates, predictor, trials);
  for (std::vector<measure::Method> left = all, now; !left.empty();) {
    const bool first = left.size() == all.size();
    now = take_quickest(left);
    search.search(search.fast_enough(now, all), first ? progress : Progress{});
  }
  time_well(search.finalists(), trials, rounds);
  report(progress, 1);
  return fastest(search.finalists(), trials);
}

std::optional<measure::Method> fastest_of_all(const Candidates& candidates,
                                              const std::optional<measure::Method>& chosen,
                                              Trials& trials, int rounds,
                                              const Progress& progress) {
  trials.time(on_coarsest(candidates), kFirst);
  // More triangles take longer with any method.
  const auto hopeless = [&](const measure::Method& method) {
    const double min = trials.min_ratio(measure::with_grid(method, candidates.ladder.front()));
    return chosen && min > 2 * trials.ratio(*chosen);
  };
  std::vector<measure::Method> meeting;
  double done = 0;
  for (const measure::GridSize& grid : candidates.ladder) {
    for (const measure::Method& without_grid : candidates.methods) {
      const measure::Method method = measure::with_grid(without_grid, grid);
      if (trials.result(method).met && !hopeless(method)) meeting.push_back(method);
    }
    report(progress, 0.6 * ++done / double(candidates.ladder.size()));
  }
  time_well(meeting, trials, rounds);
  if (chosen) {
    std::vector<measure::Method> last = contenders(meeting, kContender, trials);
    last.push_back(*chosen);
    trials.time(last, kBetter * rounds);
  }
  report(progress, 1);
  return fastest(meeting, trials);
}

measure::Method closest_method(const Candidates& candidates, const MeasurementStore& store) {
  measure::Method closest =
      measure::with_grid(candidates.methods.front(), candidates.ladder.back());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> min{kInfinity, kInfinity};
  for (const measure::GridSize& grid : candidates.ladder) {
    for (const measure::Method& without_grid : candidates.methods) {
      const measure::Method method = measure::with_grid(without_grid, grid);
      const auto known = store.results().find(measure::method_name(method));
      if (known == store.results().end()) continue;
      const std::pair<double, double> missed{double(known->second.lacking), known->second.error};
      if (missed >= min) continue;
      min = missed;
      closest = method;
    }
  }
  return closest;
}

}  // namespace lumaknot::plan
