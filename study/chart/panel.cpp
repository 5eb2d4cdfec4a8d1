#include "study/chart/panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "system/known.h"

namespace lumaknot::chart {
namespace {

constexpr double kMin = 1e-7;  // what the logarithmic axis shows of no error at all

// Of a text in kLabelFont, pixels: a little more than Sans and sans-serif need.
constexpr double kCharacter = 7.5, kHeight = 13;

/// Where times and errors are in a panel.
class PanelScale {
 public:
  PanelScale(const ChartAxes& axes, const PlaceBox& panel) : axes_(axes), panel_(panel) {}

  PlacePoint at(double time, double error) const {
    return {panel_.left + panel_.width() * share(axes_.time, time),
            panel_.bottom - panel_.height() * share(axes_.error, error)};
  }

 private:
  static double share(const Interval<double>& range, double value) {
    return std::log(value / range.min) / std::log(range.max / range.min);
  }

  ChartAxes axes_;
  PlaceBox panel_;
};

PanelLabel label_at(const PlacePoint& point, std::string text, std::string_view color) {
  const double width = kCharacter * double(text.size());
  return {std::move(text), color, {point, width, kHeight}};
}

}  // namespace

PlaceBox panel_box(std::size_t truth) {
  const double left = (truth == 0 ? 0.065 : 0.56) * kWidth;
  return {left, kTop, left + 0.425 * kWidth, kTop + kPanel};
}

double shown_error(const ChartPoint& point, const Metric& metric, std::size_t truth) {
  return std::max(kMin, known(error_from(point, metric, truth)));
}

bool is_shown(const Chart& chart, const ChartPoint& point, std::size_t truth) {
  return point.errors[truth] && frame_time(chart, point);
}

std::optional<ChartAxes> chart_axes(const Chart& chart, const Metric& metric) {
  std::vector<double> errors, times;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (const ChartPoint& point : chart.points) {
      if (!is_shown(chart, point, truth)) continue;
      const measure::Spread time = known(frame_time(chart, point));
      errors.push_back(shown_error(point, metric, truth));
      times.insert(times.end(), {time.min, time.max});
    }
  }
  if (errors.empty()) return {};
  return ChartAxes{{std::ranges::min(times) / 1.5, std::ranges::max(times) * 1.5},
                   {std::ranges::min(errors) / 1.6, std::ranges::max(errors) * 1.6}};
}

std::string_view front_color(std::size_t index) {
  constexpr std::array<std::string_view, 4> kColors{"#c0392b", "#1b6e3c", "#1f4e9c", "#8a6d00"};
  return kColors[index % kColors.size()];
}

PanelLabels panel_labels(const Chart& chart, const Metric& metric, std::size_t truth) {
  PanelLabels result;
  const std::optional<ChartAxes> axes = chart_axes(chart, metric);
  if (!axes) return result;
  const PanelScale scale(*axes, panel_box(truth));
  const auto at = [&](const ChartPoint& point) {
    return scale.at(known(frame_time(chart, point)).median, shown_error(point, metric, truth));
  };
  std::size_t index = 0, number = 0;
  for (const Space space : spaces_in(chart)) {
    std::optional<PlacePoint> last;
    for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
      const PlacePoint point = at(chart.points[i]);
      result.labels.push_back(label_at(point, std::to_string(++number), front_color(index)));
      if (last) result.obstacles.lines.push_back({*last, point});
      last = point;
    }
    ++index;
  }
  std::vector<std::string> named;
  for (const ChartPoint& point : chart.points) {
    if (!is_shown(chart, point, truth)) continue;
    const measure::Spread time = known(frame_time(chart, point));
    const double error = shown_error(point, metric, truth);
    result.obstacles.points.push_back(at(point));
    result.obstacles.lines.push_back({scale.at(time.min, error), scale.at(time.max, error)});
    const std::string program = point.name.substr(0, point.name.find(' '));
    if (point.method || std::ranges::count(named, program) > 0) continue;
    named.push_back(program);
    result.labels.push_back(label_at(at(point), program, "#000000"));
  }
  return result;
}

}  // namespace lumaknot::chart
