#include "study/chart/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "scene/fields.h"
#include "study/measure/fingerprint.h"
#include "study/measure/frame_time.h"

namespace lumaknot::chart {
namespace {

namespace fs = std::filesystem;

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

/// The first round in which a method is still to be timed.
int finished_rounds(const Chart& chart, int rounds) {
  const auto lacks = [](int round) {
    return [round](const ChartPoint& p) {
      return p.method && measure::needs_round(p.milliseconds, std::size_t(round));
    };
  };
  int done = 0;
  while (done < rounds && std::ranges::none_of(chart.points, lacks(done))) ++done;
  return done;
}

/// What is measured so far: exact pictures, errors, times.
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

measure::CheckpointKeys chart_keys(const Chart& chart) {
  return {{"scene", chart.scene_key}, {"program", chart.program_key}};
}

std::string reason_to_start_again(const measure::LoadResult& stale) {
  if (stale.field.empty()) return "is not a chart";
  if (stale.field == "scene") return "is of another scene";
  return "is of another lumaknot or another machine";
}

std::string chart_standing(const ChartJob& job, const fs::path& folder) {
  Chart wanted;
  wanted.scene_key = measure::scene_key(job.scene, job.mesh);
  wanted.program_key = measure::program_key();
  std::optional<Chart> kept;
  measure::Checkpoint(folder / kChartFile, chart_keys(wanted))
      .load([&](const nlohmann::ordered_json& json) { kept = chart_from(json); });
  const int truths = kept ? kept_truths(job, folder) : 0;
  if (!kept || truths == 0) return "nothing is kept yet";
  return fmt::format("{} are measured and kept in {}; the same command goes on",
                     measured(job, *kept, truths), folder.string());
}

}  // namespace lumaknot::chart
