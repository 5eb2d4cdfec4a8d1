#include "study/measure/gnuplot.h"

#include <gtest/gtest.h>

#include "system/error.h"

namespace lumaknot::measure {
namespace {

constexpr std::string_view kLine = "$data << EOD\n1 2\n3 4\nEOD\nplot $data with lines title 'a'";

TEST(Gnuplot, draws_the_same_bytes_again_as_svg_and_as_png) {
  const std::string svg = draw_chart(kLine, ChartFormat::kSvg);
  const std::string png = draw_chart(kLine, ChartFormat::kPng);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(draw_chart(kLine, ChartFormat::kSvg), svg);
  EXPECT_EQ(draw_chart(kLine, ChartFormat::kPng), png);
}

TEST(Gnuplot, reports_what_it_rejected) {
  try {
    draw_chart("plot $nothing", ChartFormat::kSvg);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("$nothing"), std::string::npos);
  }
}

}  // namespace
}  // namespace lumaknot::measure
