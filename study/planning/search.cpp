#include "study/planning/search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumaknot {
namespace {

constexpr double kClearly = 1.05;    // slower by this share is slower
constexpr double kContender = 1.15;  // within this of the best, a time is measured better
constexpr int kFirst = 2;            // rounds of all
constexpr int kBetter = 3;           // times the rounds
constexpr std::size_t kNeighbours = 2;

void report(const Progress& progress, double done) {
  if (progress) progress(std::min(done, 1.0));
}

/// The search of one way's grids.
class Rungs {
 public:
  Rungs(const Method& way, std::span<const GridSize> ladder, Workshop& workshop)
      : way_(way), ladder_(ladder), workshop_(workshop) {}

  Method at(std::size_t rung) const { return with_grid(way_, ladder_[rung]); }
  bool meets(std::size_t rung) { return workshop_.judgement(at(rung)).met; }
  bool fails_by_far(std::size_t rung) { return workshop_.judgement(at(rung)).failing > kFar; }

  /// The coarsest that meets the tolerance, begun at `guess`. Errors need not fall from rung to
  /// rung: below what is found all are tried until two fail by far.
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

  /// One that meets it at `guess` or farther up, in growing steps; none where both that and the
  /// finest grid fail by far, as another filter or too few samples do.
  std::optional<std::size_t> first_from(std::size_t guess) {
    if (fails_by_far(guess) && fails_by_far(ladder_.size() - 1)) return {};
    for (std::size_t step = 1, rung = guess;; rung += step, step *= 2) {
      const std::size_t tried = std::min(rung, ladder_.size() - 1);
      if (meets(tried)) return tried;
      if (tried + 1 == ladder_.size()) return {};
    }
  }

  /// The nearest below `high` that doesn't meet it, in growing steps; -1: all that were tried do.
  long below(std::size_t& high) {
    for (long step = 1;; step *= 2) {
      const long rung = long(high) - step;
      if (rung < 0) return high > 0 && !meets(0) ? 0 : -1;
      if (!meets(std::size_t(rung))) return rung;
      high = std::size_t(rung);
    }
  }

  Method way_;
  std::span<const GridSize> ladder_;
  Workshop& workshop_;
};

std::optional<Method> fastest(std::span<const Method> methods, Workshop& workshop) {
  std::optional<Method> best;
  for (const Method& m : methods) {
    if (!best || workshop.ratio(m) < workshop.ratio(*best)) best = m;
  }
  return best;
}

/// Those within `share` of the fastest.
std::vector<Method> contenders(std::span<const Method> methods, double share, Workshop& workshop) {
  const std::optional<Method> best = fastest(methods, workshop);
  std::vector<Method> near;
  for (const Method& m : methods) {
    if (workshop.least_ratio(m) <= share * workshop.ratio(*best)) near.push_back(m);
  }
  return near;
}

/// Every method a little, the contenders more often, the closest of them more often still.
void time_well(std::span<const Method> methods, Workshop& workshop, int rounds) {
  if (methods.empty()) return;
  workshop.time(methods, kFirst);
  workshop.time(contenders(methods, 1.5, workshop), rounds);
  workshop.time(contenders(methods, kContender, workshop), kBetter * rounds);
}

/// The first rung of which the prediction promises the tolerance; where it never does, the first
/// whose place it promises. What the texture's filter may do is left to measuring.
std::size_t guessed_rung(const Method& way, std::span<const GridSize> ladder,
                         const Predictor& predictor) {
  const auto first = [&](auto promised) {
    std::size_t rung = 0;
    while (rung + 1 < ladder.size() && !promised(predictor.of(with_grid(way, ladder[rung])))) {
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

std::vector<Method> on_coarsest(const Choices& choices) {
  std::vector<Method> coarse;
  for (const Method& way : choices.ways) coarse.push_back(with_grid(way, choices.ladder.front()));
  return coarse;
}

/// Whether `quicker` is the same way in double with fewer samples. Each is shaded: with four times
/// as many a frame takes nearly four times as long, and long to be timed at all.
bool is_quicker(const Method& quicker, const Method& way) {
  Method same = way;
  same.samples = quicker.samples;
  return way.number == Number::kDouble && quicker == same && quicker.samples < way.samples;
}

/// Takes out of `ways` all but those that are others with more samples.
std::vector<Method> take_quickest(std::vector<Method>& ways) {
  std::vector<Method> quickest, slower;
  for (const Method& way : ways) {
    const auto quicker = [&](const Method& m) { return is_quicker(m, way); };
    (std::ranges::any_of(ways, quicker) ? slower : quickest).push_back(way);
  }
  ways = std::move(slower);
  return quickest;
}

/// The search of all ways.
class WaySearch {
 public:
  WaySearch(const Choices& choices, const Predictor& predictor, Workshop& workshop)
      : choices_(choices), predictor_(predictor), workshop_(workshop) {}

  /// Those of `ways` that are fast enough on their coarsest grid, the fastest first.
  void search(std::vector<Method> ways, const Progress& progress) {
    workshop_.time(ways, kFirst);
    std::ranges::stable_sort(ways, {}, [&](const Method& m) { return workshop_.least_ratio(m); });
    double done = 0;
    for (const Method& way : ways) {
      report(progress, 0.8 * done++ / double(ways.size()));
      if (!is_too_slow(way)) search(way);
    }
  }

  /// Those of `ways`, none of them searched or timed, that may be fast enough, having more samples
  /// than others; of each four times as many take twice as long at least.
  std::vector<Method> fast_enough(std::vector<Method> ways, std::span<const Method> all) {
    std::erase_if(ways, [&](const Method& way) {
      return std::ranges::any_of(all, [&](const Method& quicker) {
        return is_quicker(quicker, way) &&
               is_too_slow(quicker, std::sqrt(double(way.samples) / quicker.samples));
      });
    });
    return ways;
  }

  std::span<const Method> finalists() const { return finalists_; }

 private:
  /// Whether the best that was found is faster than so many times that way's coarsest grid's time.
  bool is_too_slow(const Method& way, double times = 1) {
    const std::optional<Method> best = fastest(finalists_, workshop_);
    return best && times * workshop_.least_ratio(way) > kClearly * workshop_.ratio(*best);
  }

  void search(const Method& way) {
    Rungs rungs(way, choices_.ladder, workshop_);
    const auto found = rungs.coarsest(guessed_rung(way, choices_.ladder, predictor_));
    if (!found) return;
    const std::size_t last = std::min(*found + kNeighbours, choices_.ladder.size() - 1);
    for (std::size_t rung = *found; rung <= last; ++rung) {
      if (rungs.meets(rung)) finalists_.push_back(rungs.at(rung));
    }
    workshop_.time(finalists_, kFirst);
  }

  const Choices& choices_;
  const Predictor& predictor_;
  Workshop& workshop_;
  std::vector<Method> finalists_;
};

}  // namespace

std::optional<Method> fastest_that_meets(const Choices& choices, const Predictor& predictor,
                                         Workshop& workshop, int rounds, const Progress& progress) {
  const std::vector<Method> all = on_coarsest(choices);
  WaySearch search(choices, predictor, workshop);
  for (std::vector<Method> left = all, now; !left.empty();) {
    const bool first = left.size() == all.size();
    now = take_quickest(left);
    search.search(search.fast_enough(now, all), first ? progress : Progress{});
  }
  time_well(search.finalists(), workshop, rounds);
  report(progress, 1);
  return fastest(search.finalists(), workshop);
}

std::optional<Method> fastest_of_all(const Choices& choices, const std::optional<Method>& chosen,
                                     Workshop& workshop, int rounds, const Progress& progress) {
  workshop.time(on_coarsest(choices), kFirst);
  // More triangles take longer, whatever the way.
  const auto hopeless = [&](const Method& way) {
    const double least = workshop.least_ratio(with_grid(way, choices.ladder.front()));
    return chosen && least > 2 * workshop.ratio(*chosen);
  };
  std::vector<Method> meeting;
  double done = 0;
  for (const GridSize& grid : choices.ladder) {
    for (const Method& way : choices.ways) {
      const Method method = with_grid(way, grid);
      if (workshop.judgement(method).met && !hopeless(way)) meeting.push_back(method);
    }
    report(progress, 0.6 * ++done / double(choices.ladder.size()));
  }
  time_well(meeting, workshop, rounds);
  if (chosen) {
    std::vector<Method> last = contenders(meeting, kContender, workshop);
    last.push_back(*chosen);
    workshop.time(last, kBetter * rounds);
  }
  report(progress, 1);
  return fastest(meeting, workshop);
}

Method closest_method(const Choices& choices, const Notebook& notebook) {
  Method closest = with_grid(choices.ways.front(), choices.ladder.back());
  double least = std::numeric_limits<double>::infinity();
  for (const GridSize& grid : choices.ladder) {
    for (const Method& way : choices.ways) {
      const Method method = with_grid(way, grid);
      const auto known = notebook.judgements().find(method_name(method));
      if (known == notebook.judgements().end() || known->second.error >= least) continue;
      least = known->second.error;
      closest = method;
    }
  }
  return closest;
}

}  // namespace lumaknot
