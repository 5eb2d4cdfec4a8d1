// lumaknot chart, run as a program. No test depends on timings.
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAreArray;

class ChartCommand : public Program {
 protected:
  void SetUp() override { write("small.json", kSmall); }

  static constexpr const char* kSmall =
      R"({"mesh": {"knot": {"segments": 24, "sides": 6}}, "texture": {"color": [0.8, 0.3, 0.2]},
          "image": {"width": 24, "height": 20}})";

  static std::vector<std::string> quick(const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"chart",   "small.json", "--alone", "--rounds", "1",
                                 "--space", "yiq",        "-o",      "out"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::vector<std::string> written() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("out"))) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
  nlohmann::json chart() { return nlohmann::json::parse(read("out/chart.json")); }
};

TEST_F(ChartCommand, writes_every_form_of_the_chart_and_reports_the_front) {
  const ProcessResult result = lumaknot(quick());
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("front in yiq, from the area truth"));
  EXPECT_THAT(written(), IsSupersetOf({"chart.csv", "chart.html", "chart.json", "chart.png",
                                       "chart.svg", "truth-yiq-area.exr", "truth-yiq-point.exr"}));
  EXPECT_EQ(chart()["complete"], true);
  EXPECT_FALSE(chart()["fronts"]["area"]["rmse"]["yiq"].empty());
}

TEST_F(ChartCommand, does_not_measure_again_what_is_there) {
  lumaknot(quick());
  const std::string before = read("out/chart.json");
  const ProcessResult again = lumaknot(quick({"--quiet"}));
  EXPECT_EQ(again.log, "");
  EXPECT_EQ(read("out/chart.json"), before);
}

TEST_F(ChartCommand, resumes_where_it_was_interrupted) {
  lumaknot(quick());
  auto half = chart();
  half["complete"] = false;
  half["points"][0]["errors"]["area"]["rmse"] = 0.125;  // would differ if measured again
  half["points"][1].erase("errors");
  half["points"][1]["rounds"]["ratios"] = nlohmann::json::array();
  half["points"][1]["rounds"]["milliseconds"] = nlohmann::json::array();
  write("out/chart.json", half.dump());
  EXPECT_THAT(lumaknot(quick()), ExitsWith(0));
  EXPECT_EQ(chart()["points"][0]["errors"]["area"]["rmse"], 0.125);
  EXPECT_GT(chart()["points"][1]["errors"]["area"]["rmse"], 0);
  EXPECT_EQ(chart()["complete"], true);
}

TEST_F(ChartCommand, ctrl_c_keeps_what_was_measured_and_reports_how_to_resume) {
  lumaknot(quick());
  std::vector<std::string> arguments = quick({"--rounds", "1000"});
  arguments.erase(arguments.begin() + 3, arguments.begin() + 5);
  arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
  fs::remove(path("lumaknot.log"));
  Process process({arguments, folder_.path(), sanitizer_options()});
  for (int tries = 0; tries < 500 && chart()["complete"]; ++tries) {  // until measuring starts
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  process.signal(SIGINT);
  const ProcessResult result = process.wait(std::chrono::seconds(30));
  EXPECT_THAT(result, ExitsWith(130));
  EXPECT_THAT(result.log,
              ContainsRegex("interrupted; ([0-9]+) of [0-9]+ points and [0-9]+ of 1000 "
                            "rounds are measured and kept in out; the same command goes "
                            "on"));
  EXPECT_EQ(chart()["complete"], false);
}

TEST_F(ChartCommand, another_scene_is_measured_again_and_reported) {
  lumaknot(quick());
  const std::string truth = read("out/truth-yiq-point.exr");
  write("small.json", R"({"mesh": {"knot": {"segments": 24, "sides": 6, "q": 5}},
                          "texture": {"color": [0.8, 0.3, 0.2]}, "image": {"width": 24, "height": 20}})");
  const ProcessResult result = lumaknot(quick());
  EXPECT_THAT(result.log, HasSubstr("chart.json is of another scene: measured again"));
  EXPECT_NE(read("out/truth-yiq-point.exr"), truth);
}

TEST_F(ChartCommand, a_mesh_file_is_its_own_truth_and_reported) {
  lumaknot({"mesh", "--segments", "24", "--sides", "6", "-o", "knot.obj"});
  write("small.json", R"({"mesh": {"file": "knot.obj"}, "image": {"width": 24, "height": 20}})");
  const ProcessResult result = lumaknot(quick());
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("a mesh file has no exact surface"));
}

TEST_F(ChartCommand, prints_json_on_request) {
  const ProcessResult result =
      lumaknot(quick({"--json"}));  // the last 64 KiB of the output are kept
  EXPECT_GT(result.log.size(), 1000u);
  EXPECT_TRUE(read("out/chart.json").ends_with(result.log));
}

TEST_F(ChartCommand, a_scene_that_covers_no_pixel_is_refused) {
  write("small.json", R"({"camera": {"position": [0, -3, 0], "target": [0, -9, 0]},
                          "image": {"width": 24, "height": 20}})");
  expect_refused(quick(), "covers no pixel's centre; move camera.position nearer, or turn it");
  EXPECT_THAT(files(), ElementsAre("small.json"));
}

TEST_F(ChartCommand, a_scene_that_covers_no_pixel_does_not_touch_an_existing_chart) {
  lumaknot(quick());
  const auto before = written();
  const std::string chart = read("out/chart.json");
  write("small.json", R"({"camera": {"position": [0, -3, 0], "target": [0, -9, 0]},
                          "image": {"width": 24, "height": 20}})");
  EXPECT_THAT(lumaknot(quick()), ExitsWith(2));
  EXPECT_THAT(written(), UnorderedElementsAreArray(before));
  EXPECT_EQ(read("out/chart.json"), chart);
}

TEST_F(ChartCommand, wrong_flags_and_paths_are_refused) {
  write("file", "");
  expect_refused({"chart", "small.json", "-o", "file"}, "--output file");
  expect_refused({"chart", "small.json", "-o", "file/below"}, "--output file/below");
  expect_refused({"chart", "nowhere"}, "nowhere");
  expect_refused(quick({"--metric", "psnr"}), "--metric");
  expect_refused({"chart", "small.json", "--space", "hsv"}, "hsv");
  expect_refused({"chart", "small.json", "--rounds", "0"}, "--rounds");
}

}  // namespace
}  // namespace lumaknot::cli
