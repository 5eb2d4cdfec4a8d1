#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/output_folder.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "scene/fields.h"
#include "study/chart/points.h"
#include "study/measure/gnuplot.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct ChartFlags {
  std::string scene = "figure2", output = "chart", metric = "rmse";
  std::vector<std::string> spaces;
  int rounds = 5;
  bool alone = false;
  Output out;
};

const chart::Metric& metric_named(const std::string& name) {
  return *std::ranges::find(chart::chart_metrics(), name, &chart::Metric::name);
}

/// The spaces requested, or the scene's own and YIQ.
std::vector<Space> spaces_of(const ChartFlags& flags, const Material& material) {
  if (flags.spaces.empty()) {
    if (material.space == Space::kYiq) return {Space::kYiq};
    return {material.space, Space::kYiq};
  }
  std::vector<Space> spaces;
  for (const std::string& name : flags.spaces) {
    const auto found = std::ranges::find(kSpaceNames, name);
    const Space space = Space(found - kSpaceNames.begin());
    if (std::ranges::count(spaces, space) == 0) spaces.push_back(space);
  }
  return spaces;
}

void write_all(const chart::Chart& chart, const ChartFlags& flags) {
  const fs::path folder = flags.output;
  const chart::ChartPicture picture = chart::chart_picture(chart, metric_named(flags.metric));
  const auto drawn = [&](measure::ChartFormat format) {
    return measure::draw_chart(picture.script, format, picture.width, picture.height);
  };
  const auto write = [&](const char* name, const std::string& bytes) {
    write_file(folder / name, bytes, "--output");
  };
  write("chart.svg", drawn(measure::ChartFormat::kSvg));
  write("chart.png", drawn(measure::ChartFormat::kPng));
  write("chart.csv", chart::chart_csv(chart));
  write("chart.html", chart::chart_html(chart, flags.scene));
}

void check_gnuplot() {
  if (find_program("gnuplot").empty()) {
    throw Error("gnuplot not found; install with apt-get install gnuplot-nox");
  }
}

void run(const ChartFlags& flags) {
  check_gnuplot();
  const SceneInput input = read_scene(flags.scene);
  for (const char* file : {"chart.json", "chart.svg", "chart.png", "chart.csv", "chart.html"}) {
    check_not_input(fs::path(flags.output) / file, input, "--output");
  }
  chart::ChartJob job{
      load_scene(input), input.spec.mesh, spaces_of(flags, input.spec.view.material),
      flags.rounds,      !flags.alone,    flags.metric};
  const OutputFolder output_folder(flags.output, "chart.json");
  try {
    const chart::Chart chart = chart::measure_chart(
        job, flags.output, progress_bar(flags.out, "chart"),
        [&](const std::string& line) { fmt::print(stderr, "lumaknot: {}\n", line); });
    write_all(chart, flags);
    if (flags.out.json) fmt::print("{}", chart::chart_json(chart));
    flags.out.say(chart::chart_text(chart, metric_named(flags.metric)));
    flags.out.say(fmt::format("{} points; see {}", chart.points.size(),
                              (fs::path(flags.output) / "chart.html").string()));
  } catch (const Interrupted&) {  // reported here: the interrupt ends the program soon
    fmt::print(stderr, "lumaknot: interrupted; {}\n", chart::chart_standing(job, flags.output));
    throw;
  }
}

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const chart::Metric& metric : chart::chart_metrics()) names.emplace_back(metric.name);
  return names;
}

std::vector<Argument> chart_arguments(ChartFlags& flags) {
  std::vector<Argument> all{
      scene_argument(flags.scene),
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "folder for chart.html, .svg, .png, .csv and .json; resumes an unfinished chart "
                  "there",
       .value = kFolder},
      {.names = "--metric",
       .target = &flags.metric,
       .meaning = "error metric of chart.svg and .png; chart.html offers all of them",
       .choices = metric_names()},
      {.names = "--space",
       .target = &flags.spaces,
       .meaning = "colour spaces to compute light in",
       .default_text = "the scene's own and yiq",
       .choices = {kSpaceNames.begin(), kSpaceNames.end()},
       .list = true},
      {.names = "--rounds",
       .target = &flags.rounds,
       .meaning = "number of rounds; each times every method",
       .range = Interval<double>{1, 1000}},
      {.names = "--alone",
       .target = &flags.alone,
       .meaning = "skip llvmpipe, Cycles, POV-Ray and Eevee"}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand chart_command() {
  const auto flags = std::make_shared<ChartFlags>();
  return {.name = "chart",
          .group = Group::kStudy,
          .about = "Chart the time of every method against its error, with the Pareto front",
          .arguments = chart_arguments(*flags),
          .notes = "Ctrl-C keeps what was measured; the same command resumes.",
          .examples = {{"lumaknot chart -o chart/"},
                       {"lumaknot chart scene.json --metric flip -o chart/"},
                       {"lumaknot chart figure1-back --space yiq,cielab --alone -o chart/"}},
          .run = [flags] {
            const InterruptGuard guard;
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
