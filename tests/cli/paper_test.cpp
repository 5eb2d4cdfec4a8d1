// lumaknot paper, run as a program, without other renderers. No test depends on timings.
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class PaperCommand : public Program {
 protected:
  static std::vector<std::string> alone(const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"paper",    "--alone",   "--size", "16",        "--rounds",
                                 "1",        "--seconds", "0",      "--blender", "no-blender",
                                 "--povray", "no-povray", "-o",     "out"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  nlohmann::json claims() { return nlohmann::json::parse(read("out/claims.json")); }
};

TEST_F(PaperCommand, every_claim_has_a_number_and_a_verdict) {
  const ProcessResult result = lumaknot(alone());
  ASSERT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("see out/index.html"));
  const nlohmann::json all = claims()["claims"];
  EXPECT_GT(all.size(), 40u);
  for (const auto& claim : all) {
    EXPECT_FALSE(claim["measures"].empty()) << claim["name"];
    EXPECT_FALSE(claim["how"].empty()) << claim["name"];
    const bool measurable = claim["verdict"] != "not measurable here";
    EXPECT_TRUE(measurable || claim.contains("beyond")) << claim["name"];
  }
}

TEST_F(PaperCommand, missing_renderers_are_reported_with_the_remedy_and_draw_nothing) {
  const ProcessResult result = lumaknot(alone());
  EXPECT_THAT(result.log,
              HasSubstr("Cycles is missing: no-blender not found; install with apt-get install"));
  EXPECT_THAT(result.log,
              HasSubstr("POV-Ray is missing: no-povray not found; install with apt-get install"));
  EXPECT_TRUE(fs::exists(path("out/images/front-yiq-lumaknot.png")));
  EXPECT_FALSE(fs::exists(path("out/images/front-yiq-cycles.png")));
  EXPECT_THAT(read("out/index.html"), Not(HasSubstr("front-yiq-cycles.png")));
}

TEST_F(PaperCommand, leaves_no_checkpoint_behind_when_it_is_done) {
  lumaknot(alone({"--quiet"}));
  EXPECT_FALSE(fs::exists(path("out/images/front.json")));
  EXPECT_FALSE(fs::exists(path("out/images/back.json")));
}

TEST_F(PaperCommand, ctrl_c_reports_that_pictures_without_a_renderer_are_drawn_again) {
  std::vector<std::string> arguments = alone({"--rounds", "1000"});
  arguments.erase(arguments.begin() + 4, arguments.begin() + 6);
  arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
  Process process({arguments, folder_.path(), sanitizer_options()});
  for (int tries = 0; tries < 1000 && !fs::exists(path("out/images/back.json")); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  process.signal(SIGINT);
  const ProcessResult result = process.wait(std::chrono::seconds(60));
  EXPECT_THAT(result, ExitsWith(130));
  EXPECT_THAT(result.log, HasSubstr("interrupted; nothing is kept, the same command starts over"));
  EXPECT_FALSE(fs::exists(path("out/index.html")));
}

TEST_F(PaperCommand, wrong_flags_and_paths_are_refused) {
  write("file", "");
  expect_refused({"paper", "-o", "file"}, "--output file");
  expect_refused({"paper", "--size", "3"}, "--size");
  expect_refused({"paper", "--rounds", "0"}, "--rounds");
  expect_refused({"paper", "--time-limit", "-1"}, "--time-limit");
}

}  // namespace
}  // namespace lumaknot::cli
