// The chart as gnuplot draws it.
#include <gmock/gmock.h>

#include "study/chart/points.h"
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

}  // namespace
}  // namespace lumaknot::chart
