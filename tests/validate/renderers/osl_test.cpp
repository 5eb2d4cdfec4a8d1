// Cycles of the Python module bpy, where scripts/install-extras osl has put it.
#include <gmock/gmock.h>

#include <algorithm>

#include "scene/shot.h"
#include "tests/validate/small_scene.h"
#include "validate/renderers/blender_run.h"
#include "validate/renderers/entry.h"

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

TEST(OslRenderer, without_its_python_is_missing_and_skips_with_the_remedy) {
  Programs programs;
  programs.paths[kOslProgram.flag] = "/nowhere/bin/python";
  const auto renderer = renderer_entry("OSL").make(programs);
  EXPECT_FALSE(renderer->availability().found);
  EXPECT_THAT(renderer->availability().remedy,
              HasSubstr("/nowhere/bin/python not found; scripts/install-extras osl"));
  const Rendering rendering =
      renderer->draw(testing::small_scene(), std::vector{testing::final_shot("phong")});
  EXPECT_EQ(rendering.renderer, "OSL");
  ASSERT_EQ(rendering.shots.size(), 1u);
  EXPECT_EQ(rendering.shots[0].status, RenderedShot::Status::kSkipped);
  EXPECT_THAT(rendering.shots[0].why, HasSubstr("scripts/install-extras osl"));
}

TEST(OslRenderer, of_a_python_without_bpy_is_missing) {
  Programs programs;
  programs.paths[kOslProgram.flag] = "/usr/bin/python3";  // Debian's Blender is not a module of it
  const Availability here = renderer_entry("OSL").make(programs)->availability();
  EXPECT_FALSE(here.found);
  EXPECT_THAT(here.remedy, HasSubstr("No module named 'bpy'; scripts/install-extras osl"));
}

class InstalledOsl : public ::testing::Test {
 protected:
  Availability here_ = renderer_entry("OSL").make({})->availability();

  void SetUp() override {
    if (!here_.found) GTEST_SKIP() << here_.remedy;
  }
};

TEST_F(InstalledOsl, tells_the_version_of_its_blender) {
  EXPECT_THAT(here_.version, MatchesRegex("bpy [0-9]+\\.[0-9]+\\.[0-9]+.*"));
  EXPECT_TRUE(std::filesystem::path(here_.path).is_absolute());
}

TEST_F(InstalledOsl, shader_that_does_not_compile_fails_its_shot_alone_in_the_compilers_words) {
  const Scene scene = testing::small_scene();
  const std::vector<Shot> shots{testing::final_shot("rgb-phong"), testing::final_shot("yiq-phong")};
  Package package = blender::blender_package(scene, shots, "scene", blender::ShotShaders::kOsl);
  const auto broken = std::ranges::find(package, "scene.rgb-phong.osl", &PackedFile::name);
  ASSERT_NE(broken, package.end());
  broken->bytes.insert(broken->bytes.rfind('}'), "  result = nowhere;\n");
  const BlenderRun blender{.command = {here_.path, "scene.py", "--"},
                           .environment = {},
                           .engine = "cycles",
                           .shaders = blender::ShotShaders::kOsl,
                           .time_limit = std::chrono::seconds(100)};
  const Rendering rendering = draw_package(blender, package, scene.view, shots);
  EXPECT_EQ(rendering.shots[0].status, RenderedShot::Status::kFailed);
  EXPECT_THAT(rendering.shots[0].why, HasSubstr("scene.rgb-phong.osl"));
  EXPECT_THAT(rendering.shots[0].why, HasSubstr("'nowhere' was not declared"));
  EXPECT_EQ(rendering.shots[1].status, RenderedShot::Status::kDrawn) << rendering.shots[1].why;
}

}  // namespace
}  // namespace lumaknot::validate
