#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/shared_arguments.h"
#include "cli/terminal.h"
#include "scene/atomic_file.h"
#include "study/growth.h"
#include "study/rate_report.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

struct BenchFlags {
  std::string scene = "figure2", output, picture;
  RateOptions options;
  bool alone = false, growth = false;
  Output out;
};

/// What was measured, told in each way.
struct Told {
  std::string text, json, svg;
};

Told frame_rates(const Scene& scene, const BenchFlags& flags) {
  RateOptions options = flags.options;
  options.peers = !flags.alone;
  const RateTable table = measure_rates(scene, options, progress_bar(flags.out, "bench"));
  return {rates_text(table), rates_json(table), rates_svg(table)};
}

Told growth(const Scene& scene, const MeshSpec& mesh, const BenchFlags& flags) {
  const GrowthOptions options{.threads = flags.options.threads, .seconds = flags.options.seconds};
  const std::vector<Growth> all =
      measure_growth(scene, mesh, options, progress_bar(flags.out, "bench"));
  return {growth_text(all), growth_json(all), growth_svg(all)};
}

/// Of a file that may be asked for.
void check_place(const std::string& path, std::string_view ending, const char* flag) {
  if (path.empty()) return;
  check_ending(path, {&ending, 1}, flag);
  check_writable(path, flag);
}

void run(const BenchFlags& flags) {
  check_place(flags.output, ".json", "--output");
  check_place(flags.picture, ".svg", "--picture");
  const SceneInput input = read_scene(flags.scene);
  if (!flags.output.empty()) check_not_input(flags.output, input, "--output");
  if (!flags.picture.empty()) check_not_input(flags.picture, input, "--picture");
  const Scene scene = load_scene(input);
  const Told told =
      flags.growth ? growth(scene, input.spec.mesh, flags) : frame_rates(scene, flags);
  if (!flags.output.empty()) write_file(flags.output, told.json, "--output");
  if (!flags.picture.empty()) write_file(flags.picture, told.svg, "--picture");
  if (flags.out.json) fmt::print("{}", told.json);
  flags.out.say(told.text);
}

std::vector<Argument> measuring_arguments(RateOptions& options) {
  return {{.names = "--rounds",
           .target = &options.rounds,
           .meaning = "rounds, each of which draws every row",
           .range = Bound{1, 1000}},
          {.names = "--seconds",
           .target = &options.seconds,
           .meaning = "seconds that a row is drawn in each round",
           .range = Bound{0.0, 3600.0}},
          {.names = "--threads",
           .target = &options.threads,
           .meaning = "a row for one thread and a row for N; 0: one per core",
           .range = Bound{0, 1024}},
          {.names = "--samples",
           .target = &options.samples,
           .meaning = "samples of coverage and depth per pixel, a row for each",
           .choices = {"1", "2", "4", "6", "8", "16"},
           .list = true}};
}

std::vector<Argument> bench_arguments(BenchFlags& flags) {
  std::vector<Argument> all{scene_argument(flags.scene),
                            {.names = "-o,--output",
                             .target = &flags.output,
                             .meaning = "the table as JSON: .json",
                             .value = kFile},
                            {.names = "--picture",
                             .target = &flags.picture,
                             .meaning = "the table as a bar chart: .svg",
                             .value = kFile}};
  append(all, measuring_arguments(flags.options));
  append(all, {{.names = "--alone",
                .target = &flags.alone,
                .meaning = "without llvmpipe, a GPU and Embree"},
               {.names = "--growth",
                .target = &flags.growth,
                .meaning = "measure how a frame's time grows with triangles, pixels and samples",
                .excludes = {"--alone", "--rounds", "--samples"}}});
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand bench_command() {
  const auto flags = std::make_shared<BenchFlags>();
  return {.name = "bench",
          .group = Group::kStudy,
          .about = "Time frames, classical and YIQ, beside other programs and the paper's Table 2",
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

}  // namespace lumaknot
