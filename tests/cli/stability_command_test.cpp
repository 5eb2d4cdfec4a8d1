// lumaknot stability, as the shell sees it.
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lumaknot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class Stability : public Program {};

TEST_F(Stability, names_its_regions) {
  const Ended ended = lumaknot({"stability", "--list"});
  EXPECT_EQ(ended.exit_code, 0) << ended.log;
  EXPECT_THAT(ended.log, HasSubstr("frenet-inflection"));
  EXPECT_GE(std::ranges::count(ended.log, '\n'), 25);
}

TEST_F(Stability, tells_the_boundary_of_a_single_region) {
  const Ended ended = lumaknot({"stability", "power-zero-zero"});
  EXPECT_EQ(ended.exit_code, 0) << ended.log;
  EXPECT_THAT(ended.log, ContainsRegex("power-zero-zero +7.*e-46 -> 7.*e-46 +shininess k"));
  EXPECT_THAT(ended.log, Not(HasSubstr("phong-cutoff")));
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stability, writes_page_json_and_pictures_and_goes_on_where_it_was) {
  const Ended first = lumaknot({"stability", "difference-step-long", "-o", "atlas", "--quiet"});
  EXPECT_EQ(first.exit_code, 0) << first.log;
  EXPECT_EQ(first.log, "");
  EXPECT_THAT(read("atlas/difference-step-long/chart.svg"), HasSubstr("</svg>"));
  EXPECT_EQ(read("atlas/difference-step-long/fails.png").substr(1, 3), "PNG");
  const Ended second = lumaknot({"stability", "difference-step-long", "half-way-opposite", "-o",
                                 "atlas", "--resume", "--quiet"});
  EXPECT_EQ(second.exit_code, 0) << second.log;
  const auto json = nlohmann::json::parse(read("atlas/atlas.json"));
  EXPECT_EQ(json["regions"].size(), 2u);
  EXPECT_LT(json["regions"][0]["holds"][0], json["regions"][0]["fails"][0]);
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("difference-step-long"));
}

TEST_F(Stability, keeps_what_the_folder_holds) {
  const auto examined = [&](const std::string& region) {
    const Ended ended = lumaknot({"stability", region, "-o", "atlas"});
    EXPECT_EQ(ended.exit_code, 0) << ended.log;
    return ended.log;
  };
  EXPECT_THAT(examined("half-way-opposite"), HasSubstr("\n1 region; see"));
  const auto before = nlohmann::ordered_json::parse(read("atlas/atlas.json"))["regions"][0];
  EXPECT_THAT(examined("difference-step-long"), HasSubstr("\n2 regions; see"));
  examined("difference-step-long");  // anew, once
  const auto regions = nlohmann::ordered_json::parse(read("atlas/atlas.json"))["regions"];
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0]["name"], "difference-step-long");
  EXPECT_EQ(regions[1], before);
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("section id=\"half-way-opposite\""));
  EXPECT_THAT(read("atlas/index.html"), HasSubstr("section id=\"difference-step-long\""));
}

TEST_F(Stability, leaves_a_folder_of_another_version_alone) {
  fs::create_directory(path("atlas"));
  const std::string other = R"({"version": "0.0.1", "regions": [], "energies": []})";
  for (const std::string& text : {other, std::string("{}")}) {
    write("atlas/atlas.json", text);
    expect_refused({"stability", "half-way-opposite", "-o", "atlas"}, "give another folder");
    expect_refused({"stability", "-o", "atlas", "--resume"}, "give another folder");
    EXPECT_EQ(read("atlas/atlas.json"), text);
  }
}

TEST_F(Stability, refuses_what_it_does_not_know) {
  expect_refused({"stability", "nonsense"}, "there is no region \"nonsense\"");
  expect_refused({"stability", "--resume"}, "--resume needs --output");
  write("file", "");
  expect_refused({"stability", "-o", "file"}, "--output");
  EXPECT_EQ(files(), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace lumaknot
