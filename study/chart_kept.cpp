#include "study/chart_kept.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/atomic_file.h"
#include "scene/fields.h"
#include "study/chart_keys.h"
#include "study/frame_time.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSlowRounds = 3;  // frames so slow are few, and far from any other

int kept_truths(const ChartJob& job, const fs::path& folder) {
  int count = 0;
  std::error_code ignored;
  for (const Space space : job.spaces) {
    for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
      count += fs::exists(truth_file(folder, space, truth), ignored);
    }
  }
  return count;
}

/// The first round that a method has yet to be timed in.
int finished_rounds(const Chart& chart, int rounds) {
  const auto lacks = [](int round) {
    return [round](const ChartPoint& p) { return p.method && needs_round(p, round); };
  };
  int done = 0;
  while (done < rounds && std::ranges::none_of(chart.points, lacks(done))) ++done;
  return done;
}

/// What is measured, as far as the work has come: exact pictures, errors, times.
std::string measured(const ChartJob& job, const Chart& chart, int truths) {
  const std::size_t points = chart.points.size(), all_truths = 2 * job.spaces.size();
  if (std::size_t(truths) < all_truths) {
    return fmt::format("{} of {} exact pictures", truths, all_truths);
  }
  const auto judged = std::size_t(std::ranges::count_if(
      chart.points, [](const ChartPoint& p) { return p.errors[1].has_value(); }));
  if (judged < points) {
    return fmt::format("the exact pictures and the errors of {} of {} points", judged, points);
  }
  const std::string timed = fmt::format("{} of {} points", finished_points(chart), points);
  const int rounds = finished_rounds(chart, job.rounds);
  return rounds < job.rounds ? fmt::format("{} and {} of {} rounds", timed, rounds, job.rounds)
                             : timed;
}

}  // namespace

fs::path truth_file(const fs::path& folder, Space space, std::size_t truth) {
  return folder /
         fmt::format("truth-{}-{}.exr", kSpaceNames[std::size_t(space)], kTruthNames[truth]);
}

bool is_truth_file(const fs::path& path) {
  return path.filename().string().starts_with("truth-") && path.extension() == ".exr";
}

KeptChart kept_chart(const fs::path& folder) {
  const fs::path file = folder / kChartFile;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  return {true, chart_from_json(read_file(file, kChartFile))};
}

std::string reason_to_start_anew(const KeptChart& kept, const std::string& scene_key,
                                 const std::string& program_key) {
  if (!kept.chart) return "is no chart";
  if (kept.chart->scene_key != scene_key) return "is of another scene";
  if (kept.chart->program_key != program_key) return "is of another lumaknot or another machine";
  return {};
}

bool needs_round(const ChartPoint& point, int round) {
  const std::size_t had = point.ratios.size();
  if (had > std::size_t(round)) return false;
  return had < kSlowRounds || median(point.milliseconds) < kSlowFrame;
}

std::string chart_standing(const ChartJob& job, const fs::path& folder) {
  const KeptChart kept = kept_chart(folder);
  const bool own =
      reason_to_start_anew(kept, scene_key(job.scene, job.mesh), program_key()).empty();
  const int truths = own ? kept_truths(job, folder) : 0;
  if (truths == 0) return "nothing is kept yet";
  return fmt::format("{} are measured and kept in {}; the same command goes on",
                     measured(job, *kept.chart, truths), folder.string());
}

}  // namespace lumaknot
