#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/output_folder.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "study/paper/checkpoint.h"
#include "study/paper/reproduction.h"
#include "system/atomic_file.h"
#include "system/process.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct PaperFlags {
  std::string output = "paper";
  paper::PaperJob job;
  double time_limit = 100;
  bool alone = false;
  Output out;
};

std::string progress_message(const paper::PaperJob& job, const fs::path& folder) {
  const int kept = paper::checkpointed_lights(job, folder);
  if (kept == 0) return "interrupted; nothing is kept, the same command starts over";
  return fmt::format(
      "interrupted; the pictures of {} of 2 lights are kept in {}; the same command resumes", kept,
      (folder / "images").string());
}

void run(PaperFlags flags) {
  const OutputFolder output_folder(flags.output, "index.html");
  flags.job.programs.time_limit = std::chrono::duration<double>(flags.time_limit);
  flags.job.rates.peers = !flags.alone;
  flags.job.formula_seconds = 12 * flags.job.rates.seconds;
  const fs::path folder = flags.output;
  try {
    const paper::PaperResult result =
        paper::reproduce_paper(flags.job, folder, progress_bar(flags.out, "paper"));
    const std::string json = paper::paper_json(result);
    write_file(folder / "claims.json", json, "--output");
    write_file(folder / "index.html", paper::paper_html(result), "--output");
    paper::forget_lights(folder);
    if (flags.out.json) fmt::print("{}", json);
    flags.out.say(paper::paper_text(result));
    flags.out.say(
        fmt::format("{} claims; see {}", result.claims.size(), (folder / "index.html").string()));
  } catch (const Interrupted&) {
    fmt::print(stderr, "lumaknot: {}\n", progress_message(flags.job, folder));
    throw;
  }
}

std::vector<Argument> timing_arguments(PaperFlags& flags) {
  return {{.names = "--rounds",
           .target = &flags.job.rates.rounds,
           .meaning = "number of rounds; each times every renderer",
           .range = Interval<double>{1, 1000}},
          {.names = "--seconds",
           .target = &flags.job.rates.seconds,
           .meaning = "seconds per renderer and round; formulas are timed for twelve times as long",
           .range = Interval<double>{0.0, 3600.0}},
          {.names = "--time-limit",
           .target = &flags.time_limit,
           .meaning = "seconds a renderer may take",
           .range = kPositive},
          {.names = "--alone",
           .target = &flags.alone,
           .meaning = "skip llvmpipe, the GPU and Embree in Table 2"}};
}

std::vector<Argument> paper_arguments(PaperFlags& flags) {
  std::vector<Argument> all{{.names = "-o,--output",
                             .target = &flags.output,
                             .meaning = "folder for index.html, claims.json and the pictures",
                             .value = kFolder},
                            {.names = "--size",
                             .target = &flags.job.side,
                             .meaning = "width and height of the pictures in pixels",
                             .range = Interval<double>{16, 4096}}};
  append(all, timing_arguments(flags));
  append(all, output_arguments(flags.out));
  append(all, program_arguments(flags.job.programs));
  return all;
}

}  // namespace

Subcommand paper_command() {
  const auto flags = std::make_shared<PaperFlags>();
  flags->job.rates.rounds = 3;
  flags->job.rates.seconds = 0.3;
  return {.name = "paper",
          .group = Group::kStudy,
          .about = "Reproduce the paper on one page: its figures, claims and Table 2",
          .arguments = paper_arguments(*flags),
          .notes = "Ctrl-C keeps the pictures drawn so far; the same command resumes.",
          .examples = {{"lumaknot paper -o paper/"},
                       {"lumaknot paper --rounds 10 -o paper/"},
                       {"lumaknot paper --blender /opt/blender-4.2/blender -o paper/"}},
          .run = [flags] {
            const InterruptGuard guard;
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
