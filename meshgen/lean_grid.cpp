#include "meshgen/lean_grid.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "math/angle.h"
#include "meshgen/deviation.h"
#include "meshgen/grid_model.h"
#include "meshgen/grid_scan.h"
#include "system/error.h"

namespace lumaknot {
namespace {

constexpr double kMaxVertices = 5e7;

/// Whether the quads about any witness exceed `max_error`.
bool refused(const GridModel& model, const TubeGrid& grid, double max_error) {
  const auto cell = [](double angle, int cells) {
    const double turns = angle / (2 * kPi);
    return int((turns - std::floor(turns)) * cells) + cells;
  };
  for (const Witness& witness : model.witnesses) {
    const int i = cell(witness.t, grid.segments), j = cell(witness.theta, grid.sides);
    const int first = (j - 1) % grid.sides;
    GridScan scan(false);
    GridRow low = grid_row(grid, (i - 1) % grid.segments, first, 3);
    for (int strip = i - 1; strip <= i + 1; ++strip) {
      low.segment = strip % grid.segments;
      GridRow high = grid_row(grid, low.segment + 1, first, 3);
      scan.strip(grid, low, high);
      if (scan.chords().worst() > max_error) return true;
      low = std::move(high);
    }
  }
  return false;
}

struct Candidate {
  int segments, sides;
  long long quads() const { return static_cast<long long>(segments) * sides; }
};

/// The first grid of `sides` from `segments` on that no witness refuses, if it has at most `max`
/// quads.
std::optional<Candidate> first_unrefused(const GridModel& model, int segments, int sides,
                                         long long max, double max_error) {
  if (Candidate{segments, sides}.quads() > max) return {};
  TubeGrid grid{model.surface, segments, sides, {}, {}, {}, {}, {}, {}};
  for (; Candidate{grid.segments, sides}.quads() <= max; ++grid.segments) {
    if (!refused(model, grid, max_error)) return Candidate{grid.segments, sides};
  }
  return {};
}

double measured(const GridModel& model, const Candidate& grid) {
  return measured_chord(model.surface, grid.segments, grid.sides);
}

void check(const TubeSurface& surface, const GridModel& model, double max_error) {
  if (!(max_error > 0)) {
    throw Error(fmt::format("max_error must be > 0 scene units, got {}", max_error));
  }
  if (surface.tube_radius() * model.sharpness >= 1) {
    throw Error(fmt::format(
        "no grid meets max_error {}: the tube's radius {} is not below the centre line's smallest "
        "radius of curvature, {:.3g}; make the tube thinner",
        max_error, surface.tube_radius(), 1 / model.sharpness));
  }
}

Error too_large(double max_error, double vertices) {
  return Error(fmt::format(
      "max_error {} needs about {:.2g} vertices, more than {:.0g}; allow at least {:.2g}",
      max_error, vertices, kMaxVertices, 1.1 * max_error * vertices / kMaxVertices));
}

/// The sides of the best grid of a smooth model: half of the error for each direction.
int balanced_sides(const GridModel& model, double max_error) {
  const double r = model.surface.tube_radius();
  const double sides = std::max(3.0, kPi * std::sqrt(r / max_error));
  const double segments = std::max(3.0, kPi * std::sqrt(model.peak.bulge / max_error));
  if (segments * sides > kMaxVertices) throw too_large(max_error, segments * sides);
  return std::max(int(sides), min_sides(model, max_error)) + 1;
}

/// A grid that meets the error and is close to the best, to bound the search.
LeanGrid first_guess(const GridModel& model, double max_error) {
  const int sides = balanced_sides(model, max_error);
  const int max = int(kMaxVertices) / sides;
  for (int segments = min_segments(model, sides, max_error, max);;) {
    const auto grid =
        first_unrefused(model, segments, sides, static_cast<long long>(kMaxVertices), max_error);
    if (!grid) throw too_large(max_error, 1.1 * kMaxVertices);
    const double chord = measured(model, *grid);
    if (chord <= max_error) return {grid->segments, sides, chord};
    segments = grid->segments + 1 + grid->segments / 1000;
  }
}

/// For each number of sides, the first grid of at most `max` quads that may meet the error.
std::vector<Candidate> candidates_of(const GridModel& model, double max_error, long long max) {
  const int fewest = min_sides(model, max_error);
  const int many = min_segments_of_many_sides(model, max_error);
  const int count = std::max(kManySides, int(max / many) + 1) - fewest;
  std::vector<std::optional<Candidate>> found(std::size_t(std::max(0, count)), std::nullopt);
  oneapi::tbb::parallel_for(0, count, [&](int k) {
    const int sides = fewest + k, longest = std::max(3, int(max / sides) + 1);
    const int from =
        std::max(min_segments(model, sides, max_error, longest), sides < kManySides ? 3 : many);
    found[std::size_t(k)] = first_unrefused(model, from, sides, max, max_error);
  });
  std::vector<Candidate> candidates;
  for (const auto& candidate : found) {
    if (candidate) candidates.push_back(*candidate);
  }
  return candidates;
}

/// Measures the candidates, the leanest first; one that fails is replaced by the next with the same
/// number of sides.
LeanGrid leanest(const GridModel& model, double max_error, LeanGrid best,
                 const Progress& progress) {
  const auto quads = [](const LeanGrid& g) { return Candidate{g.segments, g.sides}.quads(); };
  const auto later = [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.quads(), a.sides) > std::tuple(b.quads(), b.sides);
  };
  std::priority_queue queue(later, candidates_of(model, max_error, quads(best)));
  for (double share = 0.5; !queue.empty() && queue.top().quads() <= quads(best);) {
    const Candidate grid = queue.top();
    queue.pop();
    const double chord = measured(model, grid);
    if (chord > max_error) {
      const auto next =
          first_unrefused(model, grid.segments + 1, grid.sides, quads(best), max_error);
      if (next) queue.push(*next);
    } else if (std::pair(grid.quads(), chord) < std::pair(quads(best), best.chord)) {
      best = {grid.segments, grid.sides, chord};
    }
    if (progress) progress(share = (share + 1) / 2);  // nearly always the first or second ends it
  }
  return best;
}

}  // namespace

LeanGrid lean_grid(const TubeSurface& surface, double max_error, const Progress& progress) {
  const GridModel model = grid_model(surface);
  check(surface, model, max_error);
  if (progress) progress(0);
  const LeanGrid guess = first_guess(model, max_error);
  if (progress) progress(0.5);
  const LeanGrid best = leanest(model, max_error, guess, progress);
  if (progress) progress(1);
  return best;
}

}  // namespace lumaknot
