// lumaknot bench, run as a program. No test depends on timings.
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// The shortest measurement.
const std::vector<std::string> kQuick{"bench",     "small.json", "--alone",   "--rounds", "1",
                                      "--seconds", "0",          "--threads", "1"};

class Bench : public Program {
 protected:
  void SetUp() override { write("small.json", R"({"image": {"width": 64, "height": 48}})"); }

  static std::vector<std::string> quick(const std::vector<std::string>& more) {
    std::vector<std::string> all = kQuick;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(Bench, prints_a_row_per_number_of_samples_and_the_paper_s_rows) {
  const ProcessResult result = lumaknot(quick({"--samples", "1,4"}));
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, ContainsRegex("64 x 48 +thr +AA +classical"));
  EXPECT_THAT(result.log, ContainsRegex("lumaknot +1 +none"));
  EXPECT_THAT(result.log, ContainsRegex("lumaknot +1 +4x"));
  EXPECT_THAT(result.log, HasSubstr("GeForce GTS 250"));
}

TEST_F(Bench, writes_the_table_and_its_picture) {
  const ProcessResult result =
      lumaknot(quick({"--samples", "1", "--quiet", "-o", "table.json", "--picture", "bench.svg"}));
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_EQ(result.log, "");
  const auto table = nlohmann::json::parse(read("table.json"));
  EXPECT_EQ(table["rows"].size(), 1u);
  EXPECT_GT(table["rows"][0]["classical"]["milliseconds"]["median"], 0);
  EXPECT_THAT(read("bench.svg"), HasSubstr("</svg>"));
}

TEST_F(Bench, the_scene_may_follow_the_samples) {
  const ProcessResult result = lumaknot({"bench", "--alone", "--rounds", "1", "--seconds", "0",
                                         "--threads", "1", "--samples", "1", "small.json"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("64 x 48"));
}

TEST_F(Bench, prints_json_on_request) {
  const ProcessResult result = lumaknot(quick({"--json", "--samples", "1"}));
  EXPECT_EQ(nlohmann::json::parse(result.log)["paper"].size(), 5u);
}

TEST_F(Bench, wrong_numbers_and_scenes_are_refused) {
  expect_refused(quick({"--samples", "0"}), "--samples");
  expect_refused(quick({"--samples", "1,17"}), "17");
  expect_refused({"bench", "--rounds", "0"}, "--rounds");
  expect_refused({"bench", "--threads", "-1"}, "--threads");
  expect_refused({"bench", "--seconds", "-1"}, "--seconds");
  expect_refused({"bench", "nowhere"}, "nowhere");
  expect_refused(quick({"-o", "no/folder/table.json"}), "--output");
  expect_refused(quick({"--picture", "no/folder/bench.svg"}), "--picture");
}

TEST_F(Bench, files_of_other_kinds_are_refused_before_anything_is_timed) {
  const std::vector<std::string> endless{"bench", "small.json", "--seconds", "3600"};
  for (const bool growth : {false, true}) {
    const auto refused = [&](const std::string& flag, const std::string& name,
                             const std::string& part) {
      std::vector<std::string> arguments = endless;
      if (growth) arguments.emplace_back("--growth");
      arguments.insert(arguments.end(), {flag, name});
      expect_refused(arguments, part);
    };
    refused("--picture", "b.png", "--picture b.png must end in .svg");
    refused("--picture", "b", "--picture b must end in .svg");
    refused("-o", "table.csv", "--output table.csv must end in .json");
  }
  EXPECT_THAT(files(), ::testing::ElementsAre("small.json"));
}

}  // namespace
}  // namespace lumaknot::cli
