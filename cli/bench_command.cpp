#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/scene_input.h"
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

void add_measuring_flags(CLI::App& command, RateOptions& options) {
  command.add_option("--rounds", options.rounds, "rounds, each of which draws every row")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--seconds", options.seconds, "that a row draws in a round")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  command
      .add_option("--threads", options.threads,
                  "a row for one thread and a row for so many; 0: one for each core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command
      .add_option("--samples", options.samples,
                  "of coverage and depth a pixel, a row for each: 1, 2, 4, 6, 8, 16")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({1, 2, 4, 6, 8, 16}))
      ->capture_default_str();
}

}  // namespace

void add_bench_command(CLI::App& program) {
  auto flags = std::make_shared<BenchFlags>();
  CLI::App* command = program.add_subcommand(
      "bench", "Time frames, classical and YIQ, beside other programs and the paper's Table 2");
  command->add_option("scene", flags->scene, "scene file, built-in scene, or -")
      ->capture_default_str();
  add_measuring_flags(*command, flags->options);
  command->add_option("-o,--output", flags->output, "the table as JSON: .json");
  command->add_option("--picture", flags->picture, "the table as a bar chart: .svg");
  command->add_flag("--alone", flags->alone, "without llvmpipe, a GPU and Embree");
  command
      ->add_flag("--growth", flags->growth,
                 "instead, how a frame's time grows with triangles, pixels and samples")
      ->excludes("--alone", "--rounds", "--samples");
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot bench\n"
      "  lumaknot bench --rounds 20 -o table.json --picture bench.svg\n"
      "  lumaknot bench scene.json --samples 1,4 --threads 4 --alone\n"
      "  lumaknot bench --growth --picture growth.svg");
  command->callback([flags] {
    const InterruptGuard guard;
    run(*flags);
  });
}

}  // namespace lumaknot
