// The mesh generator: flat meshes, and measurements of the exact tube.
#include <tbb/global_control.h>

#include "bench/knot.h"
#include "meshgen/knot_mesh.h"

namespace lumaknot::bench {
namespace {

/// Builds a mesh, returns it and frees its memory; `state` has the number of triangles.
void make_knot(benchmark::State& state, Convention convention, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const KnotSpec knot = knot_of(state.range(0), convention);
  TriangleMesh mesh;
  for (auto _ : state) {
    mesh = TriangleMesh();
    mesh = knot_mesh(knot);
    benchmark::DoNotOptimize(mesh.positions.data());
    benchmark::ClobberMemory();
  }
  state.counters["vertices"] = double(mesh.positions.size());
  state.counters["triangles"] = double(mesh.triangles.size());
}

BENCHMARK_CAPTURE(make_knot, one_thread, Convention::kLumaknot, 1)
    ->Apply(repeated)
    ->ArgName("triangles")
    ->RangeMultiplier(10)
    ->Range(10'000, 10 * kMillion);
BENCHMARK_CAPTURE(make_knot, two_threads, Convention::kLumaknot, 2)
    ->Apply(repeated)
    ->ArgName("triangles")
    ->Arg(kMillion)
    ->Arg(10 * kMillion);
BENCHMARK_CAPTURE(make_knot, three_one_thread, Convention::kThree, 1)
    ->Apply(repeated)
    ->ArgName("triangles")
    ->RangeMultiplier(10)
    ->Range(10'000, kMillion);

}  // namespace
}  // namespace lumaknot::bench
