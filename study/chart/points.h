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

#include "render/reference.h"
#include "scene/spec.h"
#include "study/measure/method.h"
#include "study/measure/metrics.h"
#include "study/measure/statistics.h"

namespace lumaknot::chart {

/// The value of a pixel of the truth: at its centre, the target of methods with one sample, or the
/// mean over its square, the target of all that antialias; others are compared with it too.
inline constexpr std::array<std::string_view, 2> kTruthNames{"point", "area"};

/// An error that one might allow: 4/255.
struct ErrorLevel {
  std::string_view name;
  double value = 0;
};

/// One number of Errors.
struct Metric {
  std::string_view name, about;
  double measure::Errors::* value;
  std::array<ErrorLevel, 3> levels;  ///< for which the chart says which method to take
};

/// rmse, p99.9, max, deltae, deltae-p99.9, deltae-max, flip.
std::span<const Metric> chart_metrics();

/// One method, or one of another program's, with its measurements.
struct ChartPoint {
  std::string name;
  std::optional<measure::Method> method;  ///< empty: another program
  Space space = Space::kRgb;
  std::string how;  ///< what is particular to another program's time
  std::array<std::optional<measure::Errors>, 2>
      errors;  ///< by kTruthNames; empty if not its target
  /// Per round: the shortest time of a few frames over that of the baseline's frames next to them,
  /// and that time itself. Another program's: per frame.
  std::vector<double> ratios, milliseconds;
};

/// A program that has no points.
struct MissingPoint {
  std::string name, why;  ///< the reason and the remedy
};

struct Chart {
  std::string scene_key, program_key;  ///< of what was measured: other keys, another chart
  int width = 0, height = 0;
  std::string truth;               ///< what errors are measured from
  std::string baseline;            ///< the method that others are timed against
  std::vector<ChartPoint> points;  ///< methods first
  std::vector<MissingPoint> missing;
  bool complete = false;
};

/// A method in words, another program by its name.
std::string words_of(const ChartPoint& point);

/// The point's error from that truth; empty if the truth is not its target.
std::optional<double> error_from(const ChartPoint& point, const Metric& metric, std::size_t truth);

/// Milliseconds per frame: the ratios' median, minimum and maximum times the baseline's median;
/// other programs': their own. Empty for points without rounds.
std::optional<measure::Spread> frame_time(const Chart& chart, const ChartPoint& point);

/// Times and errors count as equal within these shares: a point that is only so much faster or
/// better does not earn a place on the front, and a machine's noise does not change the front.
inline constexpr double kSameTime = 0.05, kSameError = 0.01;

/// The Pareto front of a space, by rising error: the points that nothing with a smaller or equal
/// error comes near in time; of those that are equal in both the first. Points of other spaces draw
/// another picture and don't compete. `truth` is an index of kTruthNames.
std::vector<std::size_t> pareto_front(const Chart& chart, const Metric& metric, std::size_t truth,
                                      Space space);

/// Which method of a space to take at an error.
struct Advice {
  ErrorLevel level;
  std::optional<std::size_t> take;  ///< the fastest point within it; of equal times the first
  std::size_t nearest = 0;          ///< the point of the smallest error, for where none is
};

/// For each of the metric's levels; empty if the space has no point with a time and such an error.
std::vector<Advice> advice(const Chart& chart, const Metric& metric, std::size_t truth,
                           Space space);

/// "for an error (rmse) of at most 4/255 take grid 768 x 40, ...: 4.15 ms, rmse 0.00983".
std::string advice_sentence(const Chart& chart, const Metric& metric, std::size_t truth,
                            const Advice& advice);

/// The spaces of the chart's points, in their order.
std::vector<Space> spaces_in(const Chart& chart);

/// The points whose times are not known well enough: a front of `metric` would change if they were
/// as much longer or shorter as their rounds leave open.
std::vector<std::size_t> contested_points(const Chart& chart, const Metric& metric);

/// The usual methods for a scene with that mesh and texture, in these spaces.
std::vector<measure::Method> usual_methods(const MeshSpec& mesh, const Texture& texture,
                                           std::span<const Space> spaces);

struct ChartJob {
  Scene scene;
  MeshSpec mesh;                     ///< what the scene's mesh was built from
  std::vector<Space> spaces;         ///< no duplicates
  int rounds = 5;                    ///< per method; contested points get up to four times as many
  bool others = true;                ///< other programs too
  std::string_view metric = "rmse";  ///< whose fronts contest points
};

/// Measures what `folder` does not yet hold, and keeps each result there at once: chart.json, and
/// truth-SPACE-point.exr and -area.exr. `on_message` gets a line if it holds another scene's or
/// program's chart, which is measured again. Throws Interrupted, after which the same call resumes,
/// and Error; a scene that covers no pixel changes nothing in the folder.
Chart measure_chart(const ChartJob& job, const std::filesystem::path& folder,
                    const Progress& progress,
                    const std::function<void(const std::string&)>& on_message);

/// A line on what `folder` keeps of an unfinished chart, and that the same call resumes.
std::string chart_standing(const ChartJob& job, const std::filesystem::path& folder);

/// The number of points with errors and times.
std::size_t finished_points(const Chart& chart);

/// The chart as JSON, two spaces deep, ending in a newline.
std::string chart_json(const Chart& chart);

/// A row per point: name, space, times, errors, and per front 1 if the point is on it, else 0.
std::string chart_csv(const Chart& chart);

/// The fronts as text for a terminal.
std::string chart_text(const Chart& chart, const Metric& metric);

/// gnuplot's commands for a picture, and its size in pixels.
struct ChartPicture {
  std::string script;
  int width = 0, height = 0;
};

/// The double logarithmic chart of `metric`, the fronts marked and explained below.
ChartPicture chart_picture(const Chart& chart, const Metric& metric);

/// One HTML page that needs nothing else: choose the metric, point at a method.
std::string chart_html(const Chart& chart, const std::string& scene);

}  // namespace lumaknot::chart
