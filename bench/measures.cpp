// Measurements of a knot: how far its triangles are off, the smallest grid, how thick it may be.
#include <array>
#include <cmath>

#include "bench/knot.h"
#include "meshgen/clearance.h"
#include "meshgen/deviation.h"
#include "meshgen/lean_grid.h"

namespace lumaknot::bench {
namespace {

/// `state` has the number of quads.
void measure_deviation(benchmark::State& state) {
  const KnotSpec knot = knot_of(2 * state.range(0));
  const Spine spine(components(knot).front());
  const TubeSurface tube(spine, knot.tube_radius);
  for (auto _ : state) {
    benchmark::DoNotOptimize(measured_deviation(tube, knot.segments, knot.sides));
  }
}
BENCHMARK(measure_deviation)->Apply(repeated)->ArgName("quads")->Arg(kMillion / 2);

/// `state` has the largest error as a power of ten.
void choose_grid(benchmark::State& state) {
  const KnotSpec knot;
  const double max = std::pow(10, double(state.range(0)));
  const Spine spine(components(knot).front());
  const TubeSurface tube(spine, knot.tube_radius);
  LeanGrid grid;
  guarded(state, [&] {
    for (auto _ : state) grid = lean_grid(tube, max);
  });
  state.counters["triangles"] = 2.0 * grid.segments * grid.sides;
}
BENCHMARK(choose_grid)->Apply(repeated)->ArgName("exponent")->DenseRange(-5, -2);

void find_clearance(benchmark::State& state, int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  const std::vector<Curve> link = components(knot);
  for (auto _ : state) benchmark::DoNotOptimize(clearance(link));
}
BENCHMARK_CAPTURE(find_clearance, trefoil, 2, 3)->Apply(repeated);
BENCHMARK_CAPTURE(find_clearance, link_4_6, 4, 6)->Apply(repeated);
BENCHMARK_CAPTURE(find_clearance, knot_17_40, 17, 40)->Apply(repeated);

}  // namespace
}  // namespace lumaknot::bench
