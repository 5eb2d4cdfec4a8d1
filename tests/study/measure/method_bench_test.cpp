// Which scenes methods are drawn with, and what they are timed against.
#include "study/measure/method_bench.h"

#include <gmock/gmock.h>

#include "meshgen/knot_mesh.h"

namespace lumaknot::measure {
namespace {

KnotSpec small_knot() { return {.segments = 24, .sides = 6}; }

Scene small_scene() {
  Scene scene{knot_mesh(small_knot()), Vec3d{0.8, 0.3, 0.2}, {}};
  scene.view.image = {16, 12, 1};
  return scene;
}

TEST(MethodBench, builds_a_mesh_only_for_another_grid) {
  MethodBench bench(small_scene(), small_knot(), {});
  EXPECT_EQ(bench.scene_of({}).mesh.positions, small_scene().mesh.positions);
  EXPECT_EQ(bench.scene_of({.segments = 24, .sides = 6}).mesh.positions,
            small_scene().mesh.positions);
  const Method finer{.segments = 48, .sides = 8};
  KnotSpec knot = small_knot();
  knot.segments = 48, knot.sides = 8;
  EXPECT_EQ(bench.scene_of(finer).mesh.positions, knot_mesh(knot).positions);
  EXPECT_EQ(&bench.scene_of(finer), &bench.scene_of(finer)) << "it is kept";
}

TEST(MethodBench, draws_a_mesh_file_as_it_is) {
  MethodBench bench(small_scene(), MeshFile{"knot.obj"}, {});
  EXPECT_EQ(bench.scene_of({}).mesh.positions, small_scene().mesh.positions);
  EXPECT_EQ(bench.draw({}).width, 16);
}

TEST(MethodBench, makes_the_baseline_at_the_first_round_and_once) {
  int made = 0, drawn = 0;
  MethodBench bench(small_scene(), small_knot(), [&] {
    ++made;
    return [&] { ++drawn; };
  });
  bench.draw({});
  EXPECT_EQ(made, 0);
  int frames = 0;
  EXPECT_GT(bench.time([&] { ++frames; }).milliseconds, 0);
  bench.time(Method{});
  EXPECT_EQ(made, 1);
  EXPECT_GT(frames, 1);
  EXPECT_GT(drawn, 2);
}

TEST(NeedsRound, slow_frames_are_timed_in_the_first_rounds_only) {
  const std::vector<double> fast(4, 1.0), slow(3, 1000.0);
  EXPECT_TRUE(needs_round({}, 0));
  EXPECT_TRUE(needs_round(fast, 4));
  EXPECT_FALSE(needs_round(fast, 3));
  EXPECT_TRUE(needs_round(std::span(slow).first(2), 2));
  EXPECT_FALSE(needs_round(slow, 3));
}

}  // namespace
}  // namespace lumaknot::measure
