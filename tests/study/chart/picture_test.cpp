// The chart as gnuplot draws it.
#include <gmock/gmock.h>

#include "study/chart/panel.h"
#include "study/measure/gnuplot.h"

namespace lumaknot::chart {
namespace {

using ::testing::HasSubstr;

TEST(ChartPicture, names_the_front_s_methods_and_other_programs) {
  Chart chart;
  chart.width = 64, chart.height = 48, chart.baseline = "it's a base";
  measure::Errors errors;
  errors.rmse = 0.02;
  chart.points.push_back(
      {"it's a base", measure::Method{}, Space::kRgb, {}, {errors, errors}, {1}, {0.021449}});
  errors.rmse = 0.01;
  chart.points.push_back(
      {"Cycles mesh", std::nullopt, Space::kRgb, {}, {errors, errors}, {}, {80}});
  const ChartPicture picture = chart_picture(chart, chart_metrics().front());
  const std::string svg = measure::draw_chart(picture.script, measure::ChartFormat::kSvg,
                                              picture.width, picture.height);
  for (const char* text : {"s a base", "Cycles", "front in rgb", "64 x 48", "0.0214 ms"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

/// Programs and methods whose times and errors are alike, as they are of figure2.
Chart crowded() {
  Chart chart;
  chart.width = 64, chart.height = 48, chart.baseline = "base";
  measure::Errors errors;
  const auto add = [&](const char* name, Space space, double milliseconds, double rmse) {
    errors.rmse = rmse;
    const bool own = std::string_view(name).starts_with("base") || name[0] == 'm';
    ChartPoint point{name, {}, space, {}, {errors, errors}, {}, {milliseconds}};
    if (own) point.method = measure::Method{.space = space};
    if (own) point.ratios = {milliseconds / 8};
    chart.points.push_back(point);
  };
  add("base", Space::kRgb, 8, 0.0041);
  add("m1", Space::kYiq, 8.1, 0.0042);
  add("m2", Space::kRgb, 4.1, 0.0098);
  add("m3", Space::kYiq, 4.2, 0.0099);
  add("llvmpipe mesh", Space::kRgb, 171, 0.0100);
  add("Cycles mesh", Space::kRgb, 172, 0.0099);
  add("POV-Ray mesh", Space::kRgb, 172, 0.0101);
  add("Eevee mesh", Space::kRgb, 173, 0.0100);
  return chart;
}

TEST(ChartPicture, labels_of_methods_and_programs_that_are_alike_do_not_overlap) {
  const Chart chart = crowded();
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    const PanelLabels labels = panel_labels(chart, chart_metrics().front(), truth);
    EXPECT_EQ(labels.labels.size(), 8u);  // two fronts of two, four programs
    std::vector<PlaceLabel> places;
    for (const PanelLabel& label : labels.labels) places.push_back(label.place);
    const std::vector<PlaceBox> boxes = place_labels(places, labels.obstacles, panel_box(truth));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes[i].overlaps(boxes[k]));
    }
  }
}

}  // namespace
}  // namespace lumaknot::chart
