// lumaknot diagnose, run as a program.
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::HasSubstr;

class DiagnoseCommand : public Program {
 protected:
  void SetUp() override {
    write("scene.json", scene(0.1));
    write("brighter.json", scene(0.25));
  }
  static std::string scene(double ambient) {
    return R"({"mesh": {"knot": {"segments": 96, "sides": 10}}, "image": {"width": 48, "height": 36},
               "ambient": )" +
           std::to_string(ambient) + "}";
  }
  void render(const std::string& name, const std::string& file) {
    ASSERT_THAT(lumaknot({"render", name, "-o", file, "--quiet"}), ExitsWith(0));
  }
};

TEST_F(DiagnoseCommand, says_that_our_own_picture_agrees) {
  render("scene.json", "own.exr");
  const ProcessResult result = lumaknot({"diagnose", "own.exr", "scene.json"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("own.exr: nothing: they agree"));
}

TEST_F(DiagnoseCommand, names_the_cause_with_its_number) {
  render("brighter.json", "theirs.png");
  const ProcessResult result = lumaknot({"diagnose", "theirs.png", "scene.json"});
  EXPECT_THAT(result, ExitsWith(1));
  EXPECT_THAT(result.log, HasSubstr("ambient light 0.25, not 0.1"));
}

TEST_F(DiagnoseCommand, writes_the_cause_as_json) {
  render("brighter.json", "theirs.exr");
  const ProcessResult result = lumaknot({"diagnose", "theirs.exr", "scene.json", "--json"});
  EXPECT_THAT(result, ExitsWith(1));
  const auto json = nlohmann::json::parse(result.log);
  EXPECT_EQ(json["verdict"], "named");
  EXPECT_EQ(json["causes"][0]["id"], "ambient");
  EXPECT_NEAR(json["causes"][0]["numbers"]["ambient"]["value"].get<double>(), 0.25, 1e-4);
}

TEST_F(DiagnoseCommand, is_silent_if_quiet) {
  render("scene.json", "own.exr");
  const ProcessResult result = lumaknot({"diagnose", "own.exr", "scene.json", "--quiet"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_EQ(result.log, "");
}

TEST_F(DiagnoseCommand, refuses_what_is_not_a_picture) {
  write("text.png", "not a picture");
  expect_refused({"diagnose", "text.png", "scene.json"}, "PICTURE text.png can't be read");
  expect_refused({"diagnose", "none.png", "scene.json"}, "No such file or directory");
}

TEST_F(DiagnoseCommand, refuses_an_unknown_shader) {
  render("scene.json", "own.exr");
  expect_refused({"diagnose", "own.exr", "scene.json", "--model", "nonsense"}, "--model");
}

}  // namespace
}  // namespace lumaknot::cli
