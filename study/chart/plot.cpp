#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/fields.h"
#include "study/chart/points.h"

namespace lumaknot::chart {
namespace {

/// Points that are drawn alike.
struct Group {
  const char *title, *style;
};

constexpr std::array<Group, 5> kGroups{{{"float, light per pixel", "pt 7 ps 0.9 lc rgb '#3f7f93'"},
                                        {"float, light per vertex", "pt 9 ps 1.0 lc rgb '#d97b29'"},
                                        {"double", "pt 5 ps 0.9 lc rgb '#7a5195'"},
                                        {"half (emulated)", "pt 6 ps 1.0 lc rgb '#8c96a3'"},
                                        {"other programs", "pt 13 ps 1.3 lc rgb '#2b2b2b'"}}};

std::size_t group_of(const ChartPoint& point) {
  if (!point.method) return 4;
  if (point.method->number == measure::Number::kHalf) return 3;
  if (point.method->number == measure::Number::kDouble) return 2;
  return point.method->rate == ShadingFrequency::kVertex ? 1 : 0;
}

constexpr double kMin = 1e-7;  // what the logarithmic axis shows of no error at all

double shown_error(const ChartPoint& point, const Metric& metric, std::size_t truth) {
  return std::max(kMin, (*point.errors[truth]).*metric.value);
}

bool is_shown(const Chart& chart, const ChartPoint& point, std::size_t truth) {
  return point.errors[truth] && frame_time(chart, point);
}

std::string block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows.empty() ? "NaN NaN\n" : rows);
}

/// Escaped for a gnuplot string in single quotes.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result;
}

/// Time, error, shortest and longest time; a row per point of the group.
std::string group_rows(const Chart& chart, const Metric& metric, std::size_t truth,
                       std::size_t group) {
  std::string rows;
  for (const ChartPoint& point : chart.points) {
    if (group_of(point) != group || !is_shown(chart, point, truth)) continue;
    const measure::Spread time = *frame_time(chart, point);
    rows += fmt::format("{} {} {} {}\n", time.median, shown_error(point, metric, truth), time.min,
                        time.max);
  }
  return rows;
}

/// Numbered from `first` on.
std::string front_rows(const Chart& chart, const Metric& metric, std::size_t truth, Space space,
                       int first) {
  std::string rows;
  for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
    const ChartPoint& point = chart.points[i];
    rows += fmt::format("{} {} {}\n", frame_time(chart, point)->median,
                        shown_error(point, metric, truth), first++);
  }
  return rows;
}

/// The number of lines that a panel's fronts take.
int front_lines(const Chart& chart, const Metric& metric, std::size_t truth) {
  std::size_t lines = 0;
  for (const Space space : spaces_in(chart)) {
    lines += pareto_front(chart, metric, truth, space).size();
  }
  return int(lines);
}

/// Each other program's name at its first point. Some draw in the same time to the same error.
std::string other_labels(const Chart& chart, const Metric& metric, std::size_t truth) {
  constexpr std::array<const char*, 4> kPlaces{"left offset 0.8,-0.7", "right offset -0.8,-0.6",
                                               "right offset -0.8,0.4", "left offset 0.9,0"};
  std::string labels;
  std::vector<std::string> named;
  for (const ChartPoint& point : chart.points) {
    if (point.method || !is_shown(chart, point, truth)) continue;
    const std::string program = point.name.substr(0, point.name.find(' '));
    if (std::ranges::count(named, program) > 0) continue;
    labels += fmt::format("set label '{}' at {},{} {} font ',9'\n", escaped(program),
                          frame_time(chart, point)->median, shown_error(point, metric, truth),
                          kPlaces[named.size() % kPlaces.size()]);
    named.push_back(program);
  }
  return labels;
}

// Pixels.
constexpr int kWidth = 1280, kTop = 100, kPanel = 470, kBelow = 75, kLine = 17;

std::string front_labels(const Chart& chart, const Metric& metric, std::size_t truth, int height) {
  std::string labels;
  int number = 0;
  for (const Space space : spaces_in(chart)) {
    for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
      const ChartPoint& point = chart.points[i];
      const double y = 1 - double(kTop + kPanel + kBelow + kLine * number) / height;
      labels += fmt::format(
          "set label '{:>2}  {:>7} ms  {:8.2e}  {}' at screen {},{} font 'monospace,9'\n", ++number,
          measure::shown_time(frame_time(chart, point)->median),
          (*point.errors[truth]).*metric.value, escaped(point.name), truth == 0 ? 0.05 : 0.54, y);
    }
  }
  return labels;
}

/// A line through the front of each space, numbered.
std::string front_plots(const Chart& chart, std::size_t truth) {
  constexpr std::array<const char*, 4> kFrontColors{"#c0392b", "#1b6e3c", "#1f4e9c", "#8a6d00"};
  std::string plots;
  std::size_t index = 0;
  for (const Space space : spaces_in(chart)) {
    plots += fmt::format(
        ", $t{0}f{1} using 1:2 with lines lw 2 lc rgb '{2}' title 'front in {3}', $t{0}f{1} using "
        "1:2:3 with labels offset -0.9,-0.7 font ',10' textcolor rgb '{2}' notitle",
        truth, int(space), kFrontColors[index++ % kFrontColors.size()],
        kSpaceNames[std::size_t(space)]);
  }
  return plots;
}

std::string panel(const Chart& chart, const Metric& metric, std::size_t truth, int height) {
  constexpr std::array kTitles{"Methods of one sample, against the truth at each pixel's centre",
                               "All methods, against the mean of the truth over each pixel"};
  const double left = truth == 0 ? 0.065 : 0.56;
  std::string text = fmt::format(
      "unset label\nset lmargin at screen {}\nset rmargin at screen {}\nset title '{}'\n", left,
      left + 0.425, escaped(kTitles[truth]));
  text += front_labels(chart, metric, truth, height) + other_labels(chart, metric, truth);
  text +=
      truth == 0 ? "set key at screen 0.5,0.97 center top maxrows 2 samplen 1\n" : "unset key\n";
  text += "plot ";
  for (std::size_t g = 0; g < kGroups.size(); ++g) {
    text += fmt::format(
        "{0}$t{1}g{2} using 1:2:3:4 with xerrorbars notitle pt 0 lc rgb '#c9d0d8', "
        "$t{1}g{2} using 1:2 with points {3} title '{4}'",
        g > 0 ? ", " : "", truth, g, kGroups[g].style, kGroups[g].title);
  }
  return text + front_plots(chart, truth) + "\n";
}

/// The points of a panel as gnuplot's data.
std::string panel_data(const Chart& chart, const Metric& metric, std::size_t truth) {
  std::string text;
  for (std::size_t g = 0; g < kGroups.size(); ++g) {
    text += block(fmt::format("t{}g{}", truth, g), group_rows(chart, metric, truth, g));
  }
  int number = 1;
  for (const Space space : spaces_in(chart)) {
    const std::string rows = front_rows(chart, metric, truth, space, number);
    number += int(std::ranges::count(rows, '\n'));
    text += block(fmt::format("t{}f{}", truth, int(space)), rows);
  }
  return text;
}

/// All times and errors of the chart, with some margin.
std::string ranges(const Chart& chart, const Metric& metric) {
  std::vector<double> errors, times;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (const ChartPoint& point : chart.points) {
      if (!is_shown(chart, point, truth)) continue;
      const measure::Spread time = *frame_time(chart, point);
      errors.push_back(shown_error(point, metric, truth));
      times.insert(times.end(), {time.min, time.max});
    }
  }
  if (errors.empty()) return {};
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", std::ranges::min(times) / 1.5,
                     std::ranges::max(times) * 1.5, std::ranges::min(errors) / 1.6,
                     std::ranges::max(errors) * 1.6);
}

}  // namespace

ChartPicture chart_picture(const Chart& chart, const Metric& metric) {
  const int lines = std::max(front_lines(chart, metric, 0), front_lines(chart, metric, 1));
  const int height = kTop + kPanel + kBelow + kLine * (lines + 1);
  std::string text = panel_data(chart, metric, 0) + panel_data(chart, metric, 1);
  text += fmt::format(
      "set multiplot\nset logscale xy\nset grid lt 1 lc rgb '#e3e6ea'\nset tics nomirror\n"
      "set format y '%.0e'\nset xlabel 'milliseconds a frame, one thread, {} x {}'\nset ylabel "
      "'{}'\n"
      "set tmargin at screen {}\nset bmargin at screen {}\n",
      chart.width, chart.height, escaped(metric.about), 1 - double(kTop) / height,
      1 - double(kTop + kPanel) / height);
  text += ranges(chart, metric);
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    text += panel(chart, metric, truth, height);
  }
  return {text + "unset multiplot\n", kWidth, height};
}

}  // namespace lumaknot::chart
