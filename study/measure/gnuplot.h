/// Charts, drawn by gnuplot.
#pragma once

#include <string>
#include <string_view>

namespace lumaknot::measure {

enum class ChartFormat { kSvg, kPng };

/// The file that gnuplot (Debian: gnuplot-nox) creates from `script`, which holds its own data
/// ("$data << EOD") and says what to plot; terminal and output are set before it. Width and height
/// are in pixels. Throws Error if gnuplot is not found or rejects the script.
std::string draw_chart(std::string_view script, ChartFormat format, int width = 640,
                       int height = 400);

}  // namespace lumaknot::measure
