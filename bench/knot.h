/// Shared by all benches: the knots they build, and their repetitions.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot::bench {

inline constexpr long long kMillion = 1'000'000;

/// The default knot of `convention` in `triangles` triangles: 10^4, 10^5, 10^6 or 10^7, with about
/// ten times as many segments as sides.
inline KnotSpec knot_of(long long triangles, Convention convention = Convention::kLumaknot) {
  struct Grid {
    int segments, sides;
  };
  for (const Grid& grid : {Grid{250, 20}, {625, 80}, {2500, 200}, {6250, 800}}) {
    if (2LL * grid.segments * grid.sides != triangles) continue;
    KnotSpec knot = knot_defaults(convention);
    knot.segments = grid.segments;
    knot.sides = grid.sides;
    return knot;
  }
  throw std::logic_error(fmt::format("no grid of {} triangles", triangles));
}

/// Three repetitions by the wall clock, with their extremes.
inline void repeated(benchmark::internal::Benchmark* bench) {
  const auto min = [](const std::vector<double>& v) { return *std::ranges::min_element(v); };
  const auto max = [](const std::vector<double>& v) { return *std::ranges::max_element(v); };
  bench->UseRealTime()
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(3)
      ->ComputeStatistics("min", min)
      ->ComputeStatistics("max", max);
}

/// Runs `work`, which loops over `state`; what it throws is reported as the bench's error.
template <class Work>
void guarded(benchmark::State& state, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace lumaknot::bench
