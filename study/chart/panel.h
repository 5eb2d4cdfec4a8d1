/// The panels of the chart's picture: their axes, and what is labelled in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/interval.h"
#include "study/chart/labels.h"
#include "study/chart/points.h"

namespace lumaknot::chart {

inline constexpr int kWidth = 1280, kTop = 100, kPanel = 470;  ///< pixels: picture, above, panel
inline constexpr int kLabelFont = 9;                           ///< points

/// The box of the panel of a truth in the picture.
PlaceBox panel_box(std::size_t truth);

/// The error of a point; none at all is shown as the least of the logarithmic axis.
double shown_error(const ChartPoint& point, const Metric& metric, std::size_t truth);

/// Whether the point has a time, and an error from that truth.
bool is_shown(const Chart& chart, const ChartPoint& point, std::size_t truth);

/// Both logarithmic; the same for both panels.
struct ChartAxes {
  Interval<double> time, error;
};

/// All times and errors of the chart, with some margin; empty if it has none.
std::optional<ChartAxes> chart_axes(const Chart& chart, const Metric& metric);

/// The colour of the front of the `index`th space.
std::string_view front_color(std::size_t index);

/// A text at a point.
struct PanelLabel {
  std::string text;
  std::string_view color;
  PlaceLabel place;
};

struct PanelLabels {
  std::vector<PanelLabel> labels;
  PlaceObstacles obstacles;  ///< markers, ranges of times, fronts
};

/// The numbers of the fronts' points, and the name of each other program at its first point.
PanelLabels panel_labels(const Chart& chart, const Metric& metric, std::size_t truth);

}  // namespace lumaknot::chart
