/// What a chart's folder keeps between runs.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "study/chart/points.h"
#include "study/measure/checkpoint.h"

namespace lumaknot::chart {

inline constexpr const char* kChartFile = "chart.json";

/// truth-SPACE-point.exr or -area.exr; `truth` is an index of kTruthNames.
std::filesystem::path truth_file(const std::filesystem::path& folder, Space space,
                                 std::size_t truth);

/// Whether `path` has the name of an exact picture.
bool is_truth_file(const std::filesystem::path& path);

/// The chart's scene and program.
measure::CheckpointKeys chart_keys(const Chart& chart);

/// All of a chart except its keys.
nlohmann::ordered_json chart_values(const Chart& chart);

/// The chart that chart_json() wrote. Throws a JSON exception if it is not one.
Chart chart_from(const nlohmann::ordered_json& json);

/// Why a stale chart.json is of no use: "is of another scene".
std::string reason_to_start_again(const measure::LoadResult& stale);

}  // namespace lumaknot::chart
