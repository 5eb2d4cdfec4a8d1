#include "validate/self_test/self_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "render/reference.h"
#include "tests/validate/small_scene.h"
#include "validate/self_test/faults.h"

namespace lumaknot::validate {
namespace {

using testing::small_scene;

KnotSpec small_knot() {
  KnotSpec knot;
  knot.segments = 120;
  knot.sides = 16;
  return knot;
}

Image picture_of(const Scene& scene) {
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  return shade_all(scene, shot, visible_fragments(scene));
}

TEST(PlantedFaults, are_more_than_a_hundred_of_more_than_sixty_kinds) {
  const Scene scene = small_scene(48);
  const KnotSpec knot = small_knot();
  std::set<std::string> kinds;
  const auto faults = planted_faults(scene, &knot);
  for (const Fault& fault : faults) {
    kinds.insert(fault.expected());
    EXPECT_NE(bool(fault.scene), bool(fault.picture)) << fault.what;
  }
  EXPECT_GE(faults.size(), 100u);
  EXPECT_GE(kinds.size(), 60u);
}

TEST(PlantedFaults, change_the_picture_but_for_those_that_this_scene_does_not_show) {
  const Scene scene = small_scene(48);
  const KnotSpec knot = small_knot();
  const Image own = picture_of(scene);
  std::vector<std::string> unseen;
  for (const Fault& fault : planted_faults(scene, &knot)) {
    Scene changed = scene;
    if (fault.scene) fault.scene(changed, &knot);
    const Image picture = fault.scene ? picture_of(changed) : fault.picture(own);
    double largest = 0;
    for (std::size_t i = 0; i < own.pixels.size(); ++i) {
      const Vec3d difference = to_vec(picture.pixels[i].color) - to_vec(own.pixels[i].color);
      largest = std::max(largest, largest_magnitude(difference));
    }
    if (largest < 1e-3) unseen.push_back(fault.expected());
  }
  // The light is in front of all that is seen, and Minnaert's model is Lambert's at its default.
  EXPECT_THAT(unseen, ::testing::IsSubsetOf({"highlights-gated", "model-minnaert"}));
}

TEST(SelfTest, notices_and_names_planted_faults_and_accuses_nothing_else) {
  const SelfTest test =
      run_self_test({small_scene(64), small_knot(), {}, {}, {"srgb-encoded", "texture-flip-v"}});
  EXPECT_EQ(test.planted, 4);  // each as floats and in 8 bits
  EXPECT_EQ(test.noticed, 4);
  EXPECT_EQ(test.right, 4);
  EXPECT_EQ(test.unaltered, 2);
  EXPECT_EQ(test.accused, 0);
  EXPECT_TRUE(test.passed());
  EXPECT_THAT(self_test_markdown(test), ::testing::HasSubstr("an encoding as sRGB"));
  EXPECT_EQ(nlohmann::json::parse(self_test_json(test))["right"], 4);
}

}  // namespace
}  // namespace lumaknot::validate
