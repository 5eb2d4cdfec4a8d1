#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/fields.h"
#include "study/chart/panel.h"
#include "system/known.h"

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
    const measure::Spread time = known(frame_time(chart, point));
    rows += fmt::format("{} {} {} {}\n", time.median, shown_error(point, metric, truth), time.min,
                        time.max);
  }
  return rows;
}

std::string front_rows(const Chart& chart, const Metric& metric, std::size_t truth, Space space) {
  std::string rows;
  for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
    const ChartPoint& point = chart.points[i];
    rows += fmt::format("{} {}\n", known(frame_time(chart, point)).median,
                        shown_error(point, metric, truth));
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

// Pixels below the panels, and between lines of text.
constexpr int kBelow = 75, kLine = 17;

/// The methods of the fronts by their numbers, below the panel.
std::string front_list(const Chart& chart, const Metric& metric, std::size_t truth, int height) {
  const double left = truth == 0 ? 0.05 : 0.54;
  const auto at = [&](int line) {
    return 1 - double(kTop + kPanel + kBelow + kLine * line) / height;
  };
  std::string labels = fmt::format(
      "set label '            time     error  {}' at screen {},{} font 'monospace,9' textcolor rgb "
      "'#6b7280'\n",
      "grid, light per, space, numbers, texture, samples", left, at(0));
  int number = 0;
  for (const Space space : spaces_in(chart)) {
    for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
      const ChartPoint& point = chart.points[i];
      ++number;
      labels += fmt::format(
          "set label '{:>2}  {:>7} ms  {:8.2e}  {}' at screen {},{} font 'monospace,9'\n", number,
          measure::shown_time(known(frame_time(chart, point)).median),
          known(error_from(point, metric, truth)), escaped(point.name), left, at(number));
    }
  }
  return labels;
}

/// A line through the front of each space.
std::string front_plots(const Chart& chart, std::size_t truth) {
  std::string plots;
  std::size_t index = 0;
  for (const Space space : spaces_in(chart)) {
    plots += fmt::format(", $t{}f{} using 1:2 with lines lw 2 lc rgb '{}' title 'front in {}'",
                         truth, int(space), front_color(index++), kSpaceNames[std::size_t(space)]);
  }
  return plots;
}

/// `labels` as gnuplot's, where none lies on another, with a line to points that are far away.
std::string placed_labels(const PanelLabels& labels, const PlaceBox& panel) {
  std::vector<PlaceLabel> sizes;
  sizes.reserve(labels.labels.size());
  for (const PanelLabel& label : labels.labels) sizes.push_back(label.place);
  const std::vector<PlaceBox> boxes = place_labels(sizes, labels.obstacles, panel);
  const auto on_graph = [&](const PlacePoint& p) {
    return fmt::format("graph {:.5f},{:.5f}", (p.x - panel.left) / panel.width(),
                       (panel.bottom - p.y) / panel.height());
  };
  std::string text;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const PanelLabel& label = labels.labels[i];
    text += fmt::format("set label '{}' at {} center font ',{}' textcolor rgb '{}' front\n",
                        escaped(label.text), on_graph(boxes[i].center()), kLabelFont, label.color);
    if (!is_far_away(boxes[i], label.place.point)) continue;
    text +=
        fmt::format("set arrow from {} to {} nohead lc rgb '#8c96a3' lw 0.7\n",
                    on_graph(nearest_in(boxes[i], label.place.point)), on_graph(label.place.point));
  }
  return text;
}

std::string panel(const Chart& chart, const Metric& metric, std::size_t truth, int height) {
  constexpr std::array kTitles{"Methods of one sample, against the truth at each pixel's centre",
                               "All methods, against the mean of the truth over each pixel"};
  const PlaceBox box = panel_box(truth);
  std::string text = fmt::format(
      "unset label\nunset arrow\nset lmargin at screen {}\nset rmargin at screen {}\nset title "
      "'{}'\n",
      box.left / kWidth, box.right / kWidth, escaped(kTitles[truth]));
  text += front_list(chart, metric, truth, height);
  text += placed_labels(panel_labels(chart, metric, truth), box);
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
  for (const Space space : spaces_in(chart)) {
    text +=
        block(fmt::format("t{}f{}", truth, int(space)), front_rows(chart, metric, truth, space));
  }
  return text;
}

std::string ranges(const Chart& chart, const Metric& metric) {
  const std::optional<ChartAxes> axes = chart_axes(chart, metric);
  if (!axes) return {};
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", axes->time.min, axes->time.max,
                     axes->error.min, axes->error.max);
}

}  // namespace

ChartPicture chart_picture(const Chart& chart, const Metric& metric) {
  const int lines = std::max(front_lines(chart, metric, 0), front_lines(chart, metric, 1));
  const int height = kTop + kPanel + kBelow + kLine * (lines + 2);
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
