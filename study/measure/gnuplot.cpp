#include "study/measure/gnuplot.h"

#include <fmt/format.h>

#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::measure {
namespace {

/// The terminal's name with its options; sizes in pixels.
std::string terminal(ChartFormat format, int width, int height) {
  return format == ChartFormat::kSvg
             ? fmt::format("svg size {},{} noenhanced background 'white' font 'sans-serif,12'",
                           width, height)
             : fmt::format("pngcairo size {},{} noenhanced background 'white' font 'Sans,10'",
                           width, height);
}

}  // namespace

std::string draw_chart(std::string_view script, ChartFormat format, int width, int height) {
  const std::filesystem::path program = find_program("gnuplot");
  if (program.empty()) throw Error("gnuplot not found; install with apt-get install gnuplot-nox");
  const PrivateFolder folder;
  write_file(folder.path() / "chart.gp",
             fmt::format("set terminal {}\nset output 'chart'\nset encoding utf8\n{}\n",
                         terminal(format, width, height), script),
             "gnuplot's folder");
  const ProcessResult ended =
      run({{program.string(), "chart.gp"}, folder.path(), {}}, std::chrono::seconds(60));
  if (!ended.succeeded()) throw Error("gnuplot drew no chart: " + ended.log);
  return read_file(folder.path() / "chart", "gnuplot's chart");
}

}  // namespace lumaknot::measure
