/// What a chart's folder keeps of it between runs. Inside the chart alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/chart.h"

namespace lumaknot {

inline constexpr const char* kChartFile = "chart.json";

/// truth-SPACE-point.exr or -area.exr; `truth` is an index of kTruthNames.
std::filesystem::path truth_file(const std::filesystem::path& folder, Space space,
                                 std::size_t truth);

/// Whether `path` is named as the truths are.
bool is_truth_file(const std::filesystem::path& path);

/// The folder's chart.json.
struct KeptChart {
  bool there = false;
  std::optional<Chart> chart;  ///< none where the file is no chart
};

KeptChart kept_chart(const std::filesystem::path& folder);

/// Why what is kept is not of the scene and program with these keys; empty where it is.
std::string reason_to_start_anew(const KeptChart& kept, const std::string& scene_key,
                                 const std::string& program_key);

/// Whether a method is still to be timed in `round`, counted from 0: slow ones are in a few alone.
bool needs_round(const ChartPoint& point, int round);

}  // namespace lumaknot
