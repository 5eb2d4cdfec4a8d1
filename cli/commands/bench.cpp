#include <fmt/format.h>

#include <memory>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "study/bench/report.h"
#include "study/bench/scaling.h"
#include "system/atomic_file.h"
#include "system/process.h"

namespace lumaknot::cli {
namespace {

struct BenchFlags {
  std::string scene = "figure2", output, picture;
  bench::RateOptions options;
  bool alone = false, scaling = false;
  Output out;
};

/// The measurements in each output format.
struct BenchReport {
  std::string text, json, svg;
};

BenchReport frame_rates(const Scene& scene, const BenchFlags& flags) {
  bench::RateOptions options = flags.options;
  options.peers = !flags.alone;
  const bench::RateTable table =
      bench::measure_rates(scene, options, progress_bar(flags.out, "bench"));
  return {bench::rates_text(table), bench::rates_json(table), bench::rates_svg(table)};
}

BenchReport scaling(const Scene& scene, const MeshSpec& mesh, const BenchFlags& flags) {
  const bench::ScalingOptions options{.threads = flags.options.threads,
                                      .seconds = flags.options.seconds};
  const std::vector<bench::Scaling> all =
      bench::measure_scaling(scene, mesh, options, progress_bar(flags.out, "bench"));
  return {bench::scaling_text(all), bench::scaling_json(all), bench::scaling_svg(all)};
}

/// Checks an optional output file.
void check_optional_output(const std::string& path, std::string_view ending, const char* flag) {
  if (path.empty()) return;
  check_ending(path, {&ending, 1}, flag);
  check_writable(path, flag);
}

void run(const BenchFlags& flags) {
  check_optional_output(flags.output, ".json", "--output");
  check_optional_output(flags.picture, ".svg", "--picture");
  const SceneInput input = read_scene(flags.scene);
  if (!flags.output.empty()) check_not_input(flags.output, input, "--output");
  if (!flags.picture.empty()) check_not_input(flags.picture, input, "--picture");
  const Scene scene = load_scene(input);
  const BenchReport report =
      flags.scaling ? scaling(scene, input.spec.mesh, flags) : frame_rates(scene, flags);
  if (!flags.output.empty()) write_file(flags.output, report.json, "--output");
  if (!flags.picture.empty()) write_file(flags.picture, report.svg, "--picture");
  if (flags.out.json) fmt::print("{}", report.json);
  flags.out.say(report.text);
}

std::vector<Argument> measuring_arguments(bench::RateOptions& options) {
  return {{.names = "--rounds",
           .target = &options.rounds,
           .meaning = "number of rounds; each draws every row",
           .range = Interval<double>{1, 1000}},
          {.names = "--seconds",
           .target = &options.seconds,
           .meaning = "seconds to draw each row for, per round",
           .range = Interval<double>{0.0, 3600.0}},
          {.names = "--threads",
           .target = &options.threads,
           .meaning = "time N threads as well as one; 0 means one per core",
           .range = Interval<double>{0, 1024}},
          {.names = "--samples",
           .target = &options.samples,
           .meaning = "coverage and depth samples per pixel, one row for each",
           .choices = {"1", "2", "4", "6", "8", "16"},
           .list = true}};
}

std::vector<Argument> bench_arguments(BenchFlags& flags) {
  std::vector<Argument> all{scene_argument(flags.scene),
                            {.names = "-o,--output",
                             .target = &flags.output,
                             .meaning = "write the table as JSON (.json)",
                             .value = kFile},
                            {.names = "--picture",
                             .target = &flags.picture,
                             .meaning = "draw the table as a chart (.svg)",
                             .value = kFile}};
  append(all, measuring_arguments(flags.options));
  append(
      all,
      {{.names = "--alone", .target = &flags.alone, .meaning = "skip llvmpipe, the GPU and Embree"},
       {.names = "--growth",
        .target = &flags.scaling,
        .meaning = "measure how frame time grows with triangles, pixels and samples",
        .excludes = {"--alone", "--rounds", "--samples"}}});
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand bench_command() {
  const auto flags = std::make_shared<BenchFlags>();
  return {
      .name = "bench",
      .group = Group::kStudy,
      .about = "Time classical and YIQ lighting against other renderers and the paper's Table 2",
      .arguments = bench_arguments(*flags),
      .examples = {{"lumaknot bench"},
                   {"lumaknot bench --rounds 20 -o table.json --picture bench.svg"},
                   {"lumaknot bench scene.json --samples 1,4 --threads 4 --alone"},
                   {"lumaknot bench --growth --picture growth.svg"}},
      .run = [flags] {
        const InterruptGuard guard;
        run(*flags);
        return kExitAgreed;
      }};
}

}  // namespace lumaknot::cli
