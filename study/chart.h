/// Every method's time against its error.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"
#include "study/method.h"
#include "study/metrics.h"
#include "study/statistics.h"

namespace lumaknot {

/// What a pixel of the truth is: its centre, which methods of one sample aim at, or the mean over
/// its square, which all are judged by that claim to antialias, and the others for comparison.
inline constexpr std::array<std::string_view, 2> kTruthNames{"point", "area"};

/// One number of Errors.
struct Metric {
  std::string_view name, about;
  double Errors::* value;
};

/// rmse, p99.9, max, deltae, deltae-p99.9, deltae-max, flip.
std::span<const Metric> chart_metrics();

/// One method, or another program's way, with what was measured of it.
struct ChartPoint {
  std::string name;
  std::optional<Method> method;  ///< none: another program
  Space space = Space::kRgb;
  std::string how;                              ///< what is particular to another program's time
  std::array<std::optional<Errors>, 2> errors;  ///< by kTruthNames; none from what it is not to hit
  /// Of each round: the least time of a few frames over that of the baseline's frames beside them,
  /// and itself. Another program's: of each frame.
  std::vector<double> ratios, milliseconds;
};

/// A program that has no points.
struct MissingPoint {
  std::string name, why;  ///< the reason and the remedy
};

struct Chart {
  std::string scene_key, program_key;  ///< of what was measured: other keys, other chart
  int width = 0, height = 0;
  std::string truth;               ///< what errors are from
  std::string baseline;            ///< the method that times are taken beside
  std::vector<ChartPoint> points;  ///< methods first
  std::vector<MissingPoint> missing;
  bool complete = false;
};

/// Milliseconds a frame: the ratios' median, least and most times the baseline's median. Other
/// programs': their own. Points without rounds have none.
std::optional<Spread> frame_time(const Chart& chart, const ChartPoint& point);

/// Times count as equal within this share, errors within that: what is only so much faster or
/// better is not worth a place on the front, and differences within a machine's noise change none.
inline constexpr double kSameTime = 0.05, kSameError = 0.01;

/// The Pareto front of a space, by rising error: the points that nothing with a smaller or equal
/// error comes near in time; of those that are equal in both the first. Points of other spaces draw
/// another picture, and don't compete. `truth` is an index of kTruthNames.
std::vector<std::size_t> pareto_front(const Chart& chart, const Metric& metric, std::size_t truth,
                                      Space space);

/// The spaces of the chart's points, in their order.
std::vector<Space> spaces_in(const Chart& chart);

/// The points whose times are not known well enough: were they as much longer or shorter as their
/// rounds leave open, a front of `metric` would be another.
std::vector<std::size_t> contested_points(const Chart& chart, const Metric& metric);

/// The usual methods for a scene with that mesh and texture, in these spaces.
std::vector<Method> usual_methods(const MeshSpec& mesh, const Texture& texture,
                                  std::span<const Space> spaces);

struct ChartJob {
  Scene scene;
  MeshSpec mesh;              ///< what the scene's mesh was made of
  std::vector<Space> spaces;  ///< none twice
  int rounds = 5;      ///< that time every method; contested points get up to four times as many
  bool others = true;  ///< other programs too
  std::string_view metric = "rmse";  ///< whose fronts contest points
};

/// Measures what `folder` does not yet hold, and keeps each result there at once: chart.json, and
/// truth-SPACE-point.exr and -area.exr. `told` gets a line when what it holds is of another scene
/// or program, and is measured anew. Throws Interrupted, after which the same call goes on, and
/// Error; a scene that covers no pixel changes nothing in the folder.
Chart measure_chart(const ChartJob& job, const std::filesystem::path& folder,
                    const Progress& progress, const std::function<void(const std::string&)>& told);

/// What `folder` keeps of an unfinished chart, and that the same call goes on, in a line.
std::string chart_standing(const ChartJob& job, const std::filesystem::path& folder);

/// How many of the chart's points have errors and times.
std::size_t finished_points(const Chart& chart);

/// The chart as JSON, two spaces deep, ending in a newline, and read again: nothing where `text` is
/// no such chart.
std::string chart_json(const Chart& chart);
std::optional<Chart> chart_from_json(const std::string& text);

/// A row for each point: name, space, times, errors, and 1 where it is on its space's front, else
/// 0.
std::string chart_csv(const Chart& chart);

/// The fronts as text for a terminal.
std::string chart_text(const Chart& chart, const Metric& metric);

/// gnuplot's commands for a picture, and its size in pixels.
struct ChartPicture {
  std::string script;
  int width = 0, height = 0;
};

/// The double logarithmic chart of `metric`, the fronts marked and told below.
ChartPicture chart_picture(const Chart& chart, const Metric& metric);

/// One HTML page that needs nothing else: choose the metric, point at a method.
std::string chart_html(const Chart& chart, const std::string& scene);

}  // namespace lumaknot
