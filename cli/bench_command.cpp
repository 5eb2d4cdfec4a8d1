#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "scene/atomic_file.h"
#include "study/rate_report.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

struct BenchFlags {
  std::string scene = "figure2", output, picture;
  RateOptions options;
  bool alone = false;
  Output out;
};

void run(BenchFlags& flags) {
  if (!flags.output.empty()) check_writable(flags.output, "--output");
  if (!flags.picture.empty()) check_writable(flags.picture, "--picture");
  flags.options.peers = !flags.alone;
  const Scene scene = load_scene(read_scene(flags.scene));
  const RateTable table = measure_rates(scene, flags.options, progress_bar(flags.out, "bench"));
  if (!flags.output.empty()) write_file(flags.output, rates_json(table), "--output");
  if (!flags.picture.empty()) write_file(flags.picture, rates_svg(table), "--picture");
  if (flags.out.json) fmt::print("{}", rates_json(table));
  flags.out.say(rates_text(table));
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
  command->add_option("-o,--output", flags->output, "the table as JSON");
  command->add_option("--picture", flags->picture, "the table as a bar chart: .svg");
  command->add_flag("--alone", flags->alone, "without llvmpipe, a GPU and Embree");
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot bench\n"
      "  lumaknot bench --rounds 20 -o table.json --picture bench.svg\n"
      "  lumaknot bench scene.json --samples 1,4 --threads 4 --alone");
  command->callback([flags] {
    const InterruptGuard guard;
    run(*flags);
  });
}

}  // namespace lumaknot
