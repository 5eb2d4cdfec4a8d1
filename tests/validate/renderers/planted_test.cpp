// The self-test with renderers that are here: what is planted reaches their pictures.
#include <gtest/gtest.h>

#include "tests/validate/small_scene.h"
#include "validate/self_test/self_test.h"

namespace lumaknot::validate {
namespace {

/// The scene's fault "V flipped", and all faults of the renderers' settings.
SelfTest planted_in(const std::string& renderer) {
  KnotSpec knot;
  knot.segments = 240;  // POV-Ray turns normals on coarse meshes
  knot.sides = 24;
  Scene scene = testing::small_scene(64);
  scene.mesh = knot_mesh(knot);
  Programs programs;
  programs.paths[kGpuProgram.flag] = LUMAKNOT_GPU;
  return run_self_test({scene, knot, {renderer}, programs, {"texture-flip-v"}});
}

class PlantedIn : public ::testing::TestWithParam<std::string> {};

TEST_P(PlantedIn, a_renderer_is_noticed_and_named) {
  const SelfTest test = planted_in(GetParam());
  EXPECT_EQ(test.failed, 0);
  EXPECT_EQ(test.noticed, test.planted);
  EXPECT_EQ(test.wrong, 0);
  EXPECT_EQ(test.accused, 0);
  for (const PlantedResult& r : test.results) {
    EXPECT_TRUE(r.right) << r.drawn_by << ", " << r.fault << ": " << r.sentence << r.why;
  }
}

INSTANTIATE_TEST_SUITE_P(Renderers, PlantedIn, ::testing::Values("gl", "povray", "cycles"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lumaknot::validate
