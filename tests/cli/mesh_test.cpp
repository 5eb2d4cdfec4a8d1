#include <nlohmann/json.hpp>

#include "exporters/mesh/format.h"
#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

TEST_F(Program, a_link_has_as_many_components_as_the_greatest_common_divisor) {
  const ProcessResult result =
      lumaknot({"mesh", "--p", "4", "--q", "6", "--segments", "60", "--sides", "6", "--tube", "0.1",
                "-o", "link.obj", "--measure", "--json"});
  ASSERT_THAT(result, ExitsWith(0));
  const Json json = Json::parse(result.log);
  EXPECT_EQ(json["components"], 2);
  EXPECT_EQ(json["genus"], Json::parse("[1, 1]"));
  EXPECT_EQ(json["boundary_edges"], 0);
  EXPECT_EQ(json["triangles"], 2 * 2 * 60 * 6);
  EXPECT_EQ(files(), std::vector<std::string>{"link.obj"});
}

TEST_F(Program, measure_needs_no_output_and_prints_a_table) {
  const ProcessResult result = lumaknot({"mesh", "--segments", "60", "--sides", "6", "--measure"});
  ASSERT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("Euler characteristic  0"));
  EXPECT_THAT(result.log, HasSubstr("largest tube"));
  EXPECT_THAT(result.log, HasSubstr("ring tilt"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Program, max_error_is_met_and_nearly_reached) {
  for (const double e : {1e-2, 1e-3}) {
    const ProcessResult result =
        lumaknot({"mesh", "--max-error", std::to_string(e), "--measure", "--json"});
    ASSERT_THAT(result, ExitsWith(0));
    const double measured = Json::parse(result.log)["error_measured"]["chord"];
    EXPECT_LE(measured, e);
    EXPECT_GE(measured, 0.7 * e);
  }
}

TEST_F(Program, a_tube_that_passes_through_itself_causes_a_warning) {
  const std::vector<std::string> mesh{"mesh",    "--tube", "0.45", "--segments", "60",
                                      "--sides", "6",      "-o",   "knot.ply"};
  const ProcessResult result = lumaknot(mesh);
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("lumaknot: warning: --tube 0.45 passes through itself"));
  EXPECT_EQ(files(), std::vector<std::string>{"knot.ply"});
  std::vector<std::string> strict = mesh;
  strict.back() = "strict.ply";
  strict.push_back("--strict");
  expect_refused(strict, "--tube 0.45 passes through itself; it must be <= 0.4");
}

TEST_F(Program, every_format_is_written_and_read_as_a_scene_s_mesh) {
  for (const std::string& ending : mesh_endings(&MeshFormat::write)) {
    const std::string name = "knot" + ending;
    ASSERT_THAT(lumaknot({"mesh", "--segments", "90", "--sides", "8", "-o", name}), ExitsWith(0));
    write("scene.json", R"({"mesh": {"file": ")" + name +
                            R"("}, "texture": {"color": [1, 0.5, 0]},
                               "image": {"width": 60, "height": 60}})");
    const ProcessResult result = lumaknot({"render", "scene.json", "-o", "knot.png"});
    EXPECT_THAT(result, ExitsWith(0)) << name;
  }
}

TEST_F(Program, what_a_format_cannot_hold_is_refused) {
  expect_refused({"mesh", "--quads", "-o", "knot.stl"}, "can't hold quads");
  expect_refused({"mesh", "--ascii", "-o", "knot.glb"}, "binary only");
  expect_refused({"mesh", "--tangents", "-o", "knot.ply"}, "can't hold tangents");
  EXPECT_TRUE(files().empty());
}

TEST_F(Program, frames_that_are_undefined_are_refused) {
  // No curvature where psi = pi: w q^2 = (R - w) p^2.
  expect_refused(
      {"mesh", "--winding", "0.30769230769230771", "--frames", "frenet", "-o", "knot.obj"},
      "frames \"frenet\" are undefined");
}

}  // namespace
}  // namespace lumaknot::cli
