// Small scenes that once got a wrong verdict, judged as a user has them judged.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/process.h"
#include "tests/system/exits_with.h"

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;

class Cases : public ::testing::Test {
 protected:
  ProcessResult validate(const std::string& scene, std::vector<std::string> more) {
    std::vector<std::string> arguments{
        LUMAKNOT_PROGRAM,
        "validate",
        LUMAKNOT_SOURCE_DIR "/tests/validate/renderers/cases/" + scene + ".json",
        "--model",
        "scene",
        "-o",
        "report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run({arguments, folder_.path(), {}}, std::chrono::seconds(600));
  }
  PrivateFolder folder_;
};

TEST_F(Cases, a_cube_without_normals_is_explained_in_povray_and_agrees_elsewhere) {
  // Smooth normals of a cube face away over whole sides of it; POV-Ray turns them.
  const ProcessResult all = validate("cube", {});
  EXPECT_THAT(all, ExitsWith(1));
  EXPECT_THAT(all.log, HasSubstr("POV-Ray  explained: turned normal 1"));
  EXPECT_THAT(all.log, HasSubstr("% of the covered pixels; allow it with --allow turned-normal="));
  for (const char* line : {"Cycles   agreed", "Eevee    agreed", "GL       agreed",
                           "Vulkan   agreed", "cube.json: explained"}) {
    EXPECT_THAT(all.log, HasSubstr(line));
  }
}

TEST_F(Cases, a_cube_without_normals_agrees_where_turned_normals_are_allowed) {
  const ProcessResult result =
      validate("cube", {"--renderer", "povray", "--allow", "turned-normal=20%"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("POV-Ray  agreed"));
}

TEST_F(Cases, a_long_lens_gets_one_judgement_in_all_renderers) {
  EXPECT_THAT(validate("long-lens", {}), ExitsWith(0));
}

TEST_F(Cases, a_large_mesh_about_the_camera_agrees) {
  EXPECT_THAT(validate("mm", {}), ExitsWith(0));
}

TEST_F(Cases, a_mesh_of_a_hundred_thousandth_of_a_unit_agrees) {
  EXPECT_THAT(validate("tiny-scale", {}), ExitsWith(0));
}

}  // namespace
}  // namespace lumaknot::validate
