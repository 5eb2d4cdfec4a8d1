// What a chart's folder keeps when it is interrupted, and the message about it.
#include <gmock/gmock.h>

#include <filesystem>

#include "meshgen/knot_mesh.h"
#include "study/chart/points.h"
#include "system/process.h"

namespace lumaknot::chart {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

class ChartKept : public ::testing::Test {
 protected:
  ChartKept() {
    KnotSpec knot;
    knot.segments = 24, knot.sides = 6;
    job.mesh = knot;
    job.scene.mesh = knot_mesh(knot);
    job.scene.texture = Vec3d{0.8, 0.3, 0.2};
    job.scene.view.image = {24, 20, 1};
    job.spaces = {Space::kYiq};
    job.rounds = 2;
    job.others = false;
  }

  /// Measures until `enough` is true of the finished share.
  void measure_until(const std::function<bool(double)>& enough) {
    const auto stop = [&](double share) {
      if (enough(share)) throw Interrupted();
    };
    EXPECT_THROW(measure_chart(job, folder.path(), stop, on_message), Interrupted);
  }
  bool has(const std::string& name) const { return fs::exists(folder.path() / name); }
  std::string standing() const { return chart_standing(job, folder.path()); }

  ChartJob job;
  PrivateFolder folder;
  std::vector<std::string> lines;
  std::function<void(const std::string&)> on_message = [this](const std::string& line) {
    lines.push_back(line);
  };
};

TEST_F(ChartKept, nothing_before_the_first_truth) {
  measure_until([](double) { return true; });
  EXPECT_EQ(standing(), "nothing is kept yet");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(ChartKept, reports_the_truths_that_are_kept) {
  measure_until([&](double) { return has("truth-yiq-point.exr"); });
  EXPECT_EQ(standing(), "1 of 2 exact pictures are measured and kept in " + folder.path().string() +
                            "; the same command goes on");
}

TEST_F(ChartKept, reports_the_errors_that_are_known) {
  measure_until([](double share) { return share > 0.301; });  // after the truths
  EXPECT_THAT(standing(),
              ContainsRegex("the exact pictures and the errors of 1 of [0-9]+ points are measured "
                            "and kept in .*; the same command goes on"));
}

TEST_F(ChartKept, reports_finished_rounds_while_there_are_more) {
  measure_until([](double share) { return share > 0.88; });  // in the second of two rounds
  EXPECT_THAT(standing(), HasSubstr(" points and 1 of 2 rounds are measured and kept in"));
}

TEST_F(ChartKept, is_of_no_use_to_another_scene_even_where_only_truths_are_there) {
  measure_until([&](double) { return has("truth-yiq-point.exr"); });
  job.scene.view.ambient = 0.9;
  EXPECT_EQ(standing(), "nothing is kept yet");
  measure_until([&](double share) { return share > 0.1; });
  EXPECT_THAT(lines, ::testing::ElementsAre(HasSubstr("is of another scene: measured again")));
}

}  // namespace
}  // namespace lumaknot::chart
