#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "study/chart.h"

namespace lumaknot {
namespace {

/// Points that are drawn alike.
struct Group {
  const char *title, *style;
};

constexpr std::array<Group, 5> kGroups{{{"float, light a pixel", "pt 7 ps 0.9 lc rgb '#3f7f93'"},
                                        {"float, light a vertex", "pt 9 ps 1.0 lc rgb '#d97b29'"},
                                        {"double", "pt 5 ps 0.9 lc rgb '#7a5195'"},
                                        {"half (emulated)", "pt 6 ps 1.0 lc rgb '#8c96a3'"},
                                        {"other programs", "pt 13 ps 1.3 lc rgb '#2b2b2b'"}}};

std::size_t group_of(const ChartPoint& point) {
  if (!point.method) return 4;
  if (point.method->number == Number::kHalf) return 3;
  if (point.method->number == Number::kDouble) return 2;
  return point.method->rate == Rate::kVertex ? 1 : 0;
}

constexpr double kLeast = 1e-7;  // what the logarithmic axis shows of no error at all

double shown_error(const ChartPoint& point, const Metric& metric, std::size_t truth) {
  return std::max(kLeast, (*point.errors[truth]).*metric.value);
}

bool is_shown(const Chart& chart, const ChartPoint& point, std::size_t truth) {
  return point.errors[truth] && frame_time(chart, point);
}

std::string block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows.empty() ? "NaN NaN\n" : rows);
}

/// Within a gnuplot string in single quotes.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result;
}

/// Time, error, least and most time; a row for each point of the group.
std::string group_rows(const Chart& chart, const Metric& metric, std::size_t truth,
                       std::size_t group) {
  std::string rows;
  for (const ChartPoint& point : chart.points) {
    if (group_of(point) != group || !is_shown(chart, point, truth)) continue;
    const Spread time = *frame_time(chart, point);
    rows += fmt::format("{} {} {} {}\n", time.median, shown_error(point, metric, truth), time.least,
                        time.most);
  }
  return rows;
}

std::string front_rows(const Chart& chart, const Metric& metric, std::size_t truth) {
  std::string rows;
  int number = 0;
  for (const std::size_t i : pareto_front(chart, metric, truth)) {
    const ChartPoint& point = chart.points[i];
    rows += fmt::format("{} {} {}\n", frame_time(chart, point)->median,
                        shown_error(point, metric, truth), ++number);
  }
  return rows;
}

std::string other_rows(const Chart& chart, const Metric& metric, std::size_t truth) {
  std::string rows;
  for (const ChartPoint& point : chart.points) {
    if (point.method || !is_shown(chart, point, truth)) continue;
    const std::string program = point.name.substr(0, point.name.find(' '));
    rows += fmt::format("{} {} {}\n", frame_time(chart, point)->median,
                        shown_error(point, metric, truth), program);
  }
  return rows;
}

/// The names of a front below its panel.
std::string front_labels(const Chart& chart, const Metric& metric, std::size_t truth) {
  constexpr double kTop = 0.30, kLine = 0.021;
  std::string labels;
  int number = 0;
  for (const std::size_t i : pareto_front(chart, metric, truth)) {
    ++number;
    const ChartPoint& point = chart.points[i];
    labels += fmt::format(
        "set label {} '{:>2}  {:8.2f} ms  {:8.2e}  {}' at screen {},{} font "
        "'monospace,9'\n",
        number, number, frame_time(chart, point)->median, (*point.errors[truth]).*metric.value,
        point.name, truth == 0 ? 0.035 : 0.53, kTop - kLine * number);
  }
  return labels;
}

std::string panel(const Chart& chart, const Metric& metric, std::size_t truth) {
  const char* titles[] = {"One sample a pixel, against the truth at its centre",
                          "All methods, against the mean of the truth over the pixel"};
  const double left = truth == 0 ? 0.07 : 0.56;
  std::string text = fmt::format(
      "unset label\nset lmargin at screen {}\nset rmargin at screen {}\nset title '{}'\n", left,
      left + 0.42, titles[truth]);
  text += front_labels(chart, metric, truth);
  text += truth == 0 ? "set key at screen 0.5,0.965 center maxrows 1 samplen 1 width 1\n"
                     : "unset key\n";
  text += "plot ";
  for (std::size_t g = 0; g < kGroups.size(); ++g) {
    text += fmt::format(
        "$t{0}g{1} using 1:2:3:4 with xerrorbars notitle pt 0 lc rgb '#c9d0d8', "
        "$t{0}g{1} using 1:2 with points {2} title '{3}', ",
        truth, g, kGroups[g].style, kGroups[g].title);
  }
  return text + fmt::format(
                    "$t{0}f using 1:2 with lines lw 2 lc rgb '#c0392b' title 'front', "
                    "$t{0}f using 1:2:3 with labels offset -0.9,-0.7 font ',10' textcolor "
                    "rgb '#c0392b' notitle, $t{0}o using 1:2:3 with labels offset 0,0.9 "
                    "font ',9' notitle\n",
                    truth);
}

}  // namespace

std::string chart_plot(const Chart& chart, const Metric& metric) {
  std::string text;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (std::size_t g = 0; g < kGroups.size(); ++g) {
      text += block(fmt::format("t{}g{}", truth, g), group_rows(chart, metric, truth, g));
    }
    text += block(fmt::format("t{}f", truth), front_rows(chart, metric, truth));
    text += block(fmt::format("t{}o", truth), other_rows(chart, metric, truth));
  }
  text += fmt::format(
      "set multiplot\nset logscale xy\nset grid lc rgb '#e3e6ea'\nset tics nomirror\n"
      "set format y '1e%T'\nset xlabel 'milliseconds a frame, {} x {}'\nset ylabel '{}'\n"
      "set bmargin at screen 0.40\nset tmargin at screen 0.90\n",
      chart.width, chart.height, escaped(metric.about));
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    text += panel(chart, metric, truth);
  }
  return text + "unset multiplot\n";
}

}  // namespace lumaknot
