#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/output_folder.h"
#include "cli/terminal.h"
#include "scene/atomic_file.h"
#include "study/paper/kept_light.h"
#include "study/paper/paper.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

struct PaperFlags {
  std::string output = "paper";
  PaperJob job;
  double time_limit = 100;
  bool alone = false;
  Output out;
};

std::string where_it_stands(const PaperJob& job, const fs::path& folder) {
  const int kept = kept_lights(job, folder);
  if (kept == 0) return "interrupted; the same command begins anew";
  return fmt::format(
      "interrupted; the pictures of {} of 2 lights are kept in {}; the same command goes on", kept,
      (folder / "images").string());
}

void run(PaperFlags flags) {
  const OutputFolder made(flags.output, "index.html");
  flags.job.programs.time_limit = std::chrono::duration<double>(flags.time_limit);
  flags.job.rates.peers = !flags.alone;
  flags.job.formula_seconds = 12 * flags.job.rates.seconds;
  const fs::path folder = flags.output;
  try {
    const PaperResult result = reproduce_paper(flags.job, folder, progress_bar(flags.out, "paper"));
    const std::string json = paper_json(result);
    write_file(folder / "claims.json", json, "--output");
    write_file(folder / "index.html", paper_html(result), "--output");
    forget_lights(folder);
    if (flags.out.json) fmt::print("{}", json);
    flags.out.say(paper_text(result));
    flags.out.say(
        fmt::format("{} claims; see {}", result.claims.size(), (folder / "index.html").string()));
  } catch (const Interrupted&) {
    fmt::print(stderr, "lumaknot: {}\n", where_it_stands(flags.job, folder));
    throw;
  }
}

}  // namespace

void add_paper_command(CLI::App& program) {
  auto flags = std::make_shared<PaperFlags>();
  flags->job.rates.rounds = 3;
  flags->job.rates.seconds = 0.3;
  CLI::App* command = program.add_subcommand(
      "paper", "Reproduce the paper on one page: its figures, claims and Table 2");
  command
      ->add_option("-o,--output", flags->output,
                   "the folder for index.html, claims.json and the pictures")
      ->capture_default_str();
  command->add_option("--size", flags->job.side, "side of the pictures, pixels")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
  command
      ->add_option("--rounds", flags->job.rates.rounds,
                   "rounds, each of which times every renderer")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--seconds", flags->job.rates.seconds,
                   "that a renderer draws in a round; formulas are timed for twelve times as long")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  command->add_option("--time-limit", flags->time_limit, "seconds that a renderer may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--alone", flags->alone, "Table 2 without llvmpipe, a GPU and Embree");
  add_program_flags(*command, flags->job.programs);
  add_output_flags(*command, flags->out);
  command->footer(
      "Ctrl-C keeps the pictures that are drawn; the same command goes on.\n"
      "Examples:\n"
      "  lumaknot paper -o paper/\n"
      "  lumaknot paper --rounds 10 -o paper/\n"
      "  lumaknot paper --blender /opt/blender-4.2/blender -o paper/");
  command->callback([flags] {
    const InterruptGuard guard;
    run(*flags);
  });
}

}  // namespace lumaknot
