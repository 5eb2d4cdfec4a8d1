/// What all benches share: the knots that they make, and how they are repeated.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "scene/error.h"
#include "scene/presets.h"

namespace lumaknot::bench {

inline constexpr long long kMillion = 1'000'000;

/// The knot that `convention` makes when no number is given, in `triangles` triangles: 10^4, 10^5,
/// 10^6 or 10^7, some ten times as many segments as sides.
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
  const auto least = [](const std::vector<double>& v) { return *std::ranges::min_element(v); };
  const auto most = [](const std::vector<double>& v) { return *std::ranges::max_element(v); };
  bench->UseRealTime()
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(3)
      ->ComputeStatistics("min", least)
      ->ComputeStatistics("max", most);
}

/// Does `work`, which loops over `state`; what it throws is told in the bench's place.
template <class Work>
void guarded(benchmark::State& state, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace lumaknot::bench
