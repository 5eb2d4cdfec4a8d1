// lumaknot stability, run as a program.
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class Stability : public Program {};

TEST_F(Stability, lists_its_regions) {
  const ProcessResult result = lumaknot({"stability", "--list"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("frenet-inflection"));
  EXPECT_GE(std::ranges::count(result.log, '\n'), 25);
}

TEST_F(Stability, reports_the_boundary_of_a_single_region) {
  const ProcessResult result = lumaknot({"stability", "power-zero-zero"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, ContainsRegex("power-zero-zero +7.*e-46 -> 7.*e-46 +shininess k"));
  EXPECT_THAT(result.log, Not(HasSubstr("phong-cutoff")));
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stability, writes_page_json_and_pictures_and_resumes) {
  const ProcessResult first =
      lumaknot({"stability", "difference-step-long", "-o", "atlas", "--quiet"});
  EXPECT_THAT(first, ExitsWith(0));
  EXPECT_EQ(first.log, "");
  EXPECT_THAT(read("atlas/difference-step-long/chart.svg"), HasSubstr("</svg>"));
  EXPECT_EQ(read("atlas/difference-step-long/fails.png").substr(1, 3), "PNG");
  const ProcessResult second = lumaknot({"stability", "difference-step-long", "half-way-opposite",
                                         "-o", "atlas", "--resume", "--quiet"});
  EXPECT_THAT(second, ExitsWith(0));
  const auto json = nlohmann::json::parse(read("atlas/atlas.json"));
  EXPECT_EQ(json["regions"].size(), 2u);
  EXPECT_LT(json["regions"][0]["holds"][0], json["regions"][0]["fails"][0]);
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("difference-step-long"));
}

TEST_F(Stability, keeps_the_other_regions_of_the_folder) {
  const auto examined = [&](const std::string& region) {
    const ProcessResult result = lumaknot({"stability", region, "-o", "atlas"});
    EXPECT_THAT(result, ExitsWith(0));
    return result.log;
  };
  EXPECT_THAT(examined("half-way-opposite"), HasSubstr("\n1 region; see"));
  const auto before = nlohmann::ordered_json::parse(read("atlas/atlas.json"))["regions"][0];
  EXPECT_THAT(examined("difference-step-long"), HasSubstr("\n2 regions; see"));
  examined("difference-step-long");  // again, replacing the first
  const auto regions = nlohmann::ordered_json::parse(read("atlas/atlas.json"))["regions"];
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0]["name"], "difference-step-long");
  EXPECT_EQ(regions[1], before);
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("section id=\"half-way-opposite\""));
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("section id=\"difference-step-long\""));
}

TEST_F(Stability, does_not_touch_a_folder_of_another_version) {
  fs::create_directory(path("atlas"));
  const std::string other = R"({"version": "0.0.1", "regions": [], "energies": []})";
  for (const std::string& text : {other, std::string("{}")}) {
    write("atlas/atlas.json", text);
    expect_refused({"stability", "half-way-opposite", "-o", "atlas"}, "give another folder");
    expect_refused({"stability", "-o", "atlas", "--resume"}, "give another folder");
    EXPECT_EQ(read("atlas/atlas.json"), text);
  }
}

TEST_F(Stability, refuses_unknown_regions_and_bad_folders) {
  expect_refused({"stability", "nonsense"}, "unknown region \"nonsense\"");
  expect_refused({"stability", "--resume"}, "--resume needs --output");
  write("file", "");
  expect_refused({"stability", "-o", "file"}, "--output");
  EXPECT_EQ(files(), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace lumaknot::cli
