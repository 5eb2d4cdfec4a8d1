#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/output_folder.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/commands/shares.h"
#include "cli/terminal.h"
#include "scene/json.h"
#include "study/plan/outcome.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct PlanFlags {
  std::string scene = "figure2", output = "plan", tolerance = "1/255", in_place = "0%";
  double shift = plan::Tolerance{}.shift;
  bool exhaustive = false;
  int rounds = 5;
  Output out;
};

/// "0.004", or a fraction of a number > 0: "1/255".
double tolerance_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto above = number_of(std::string_view(text).substr(0, slash));
  const auto below =
      slash == std::string::npos ? 1 : number_of(std::string_view(text).substr(slash + 1));
  if (above && below && *below > 0) return *above / *below;
  throw Error(
      fmt::format("--tolerance must be a number or a fraction > 0, got {}; try 1/255", text));
}

/// The name of the copy of the texture.
std::string texture_name(const TextureFile& file) {
  return "texture" + fs::path(file.path).extension().string();
}

void check_no_input_overwritten(const SceneInput& input, const fs::path& folder) {
  std::vector<std::string> names{"scene.json", "certificate.json", "index.html", "measured.json"};
  if (const auto* file = std::get_if<TextureFile>(&input.spec.texture)) {
    names.push_back(texture_name(*file));
  }
  for (const std::string& name : names) check_not_input(folder / name, input, "--output");
}

/// Copies the texture next to the smaller scene, which refers to the copy.
void copy_texture(const SceneInput& input, const fs::path& folder, SceneSpec& simplified) {
  auto* file = std::get_if<TextureFile>(&simplified.texture);
  if (!file) return;
  const std::string name = texture_name(*file);
  write_file(folder / name, read_file(input.folder / file->path, "texture.file"), "--output");
  file->path = name;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += " " + word;
  return line;
}

void write_all(const SceneInput& input, plan::Plan& plan, const PlanFlags& flags) {
  const fs::path folder = flags.output;
  const std::string command =
      fmt::format("lumaknot render {}{} -o planned.png", (folder / "scene.json").string(),
                  joined(plan::render_arguments(plan.chosen.method)));
  copy_texture(input, folder, plan.simplified);
  write_file(folder / "scene.json", scene_to_json(plan.simplified), "--output");
  write_file(folder / "certificate.json", plan::plan_json(plan), "--output");
  write_file(folder / "index.html", plan::plan_html(plan, flags.scene, command), "--output");
  if (flags.out.json) fmt::print("{}", plan::plan_json(plan));
  flags.out.say(plan::plan_text(plan));
  flags.out.say(fmt::format("draw it: {}", command));
  flags.out.say(fmt::format("see {}", (folder / "index.html").string()));
}

std::string progress_message(const plan::PlanJob& job, const std::string& folder) {
  const std::size_t kept = plan::measured_choices(job, folder);
  if (kept == 0) return "interrupted; nothing is kept yet";
  return fmt::format(
      "interrupted; {} choices are measured and kept in {}; the same command resumes", kept,
      folder);
}

int run(const PlanFlags& flags) {
  const plan::Tolerance tolerance{tolerance_of(flags.tolerance), flags.shift,
                                  share_of("--in-place", flags.in_place)};
  plan::check_tolerance(tolerance, false);
  const SceneInput input = read_scene(flags.scene);
  check_no_input_overwritten(input, flags.output);
  const plan::PlanJob job{load_scene(input), input.spec, tolerance, flags.exhaustive, flags.rounds};
  plan::check_plan(job);
  const OutputFolder output_folder(flags.output, "scene.json");
  try {
    plan::Plan plan = plan::make_plan(
        job, flags.output, progress_bar(flags.out, "plan"),
        [](const std::string& line) { fmt::print(stderr, "lumaknot: {}\n", line); });
    write_all(input, plan, flags);
    return plan.met ? kExitAgreed : kExitDiffered;
  } catch (const Interrupted&) {  // reported here: the interrupt ends the program soon
    fmt::print(stderr, "lumaknot: {}\n", progress_message(job, flags.output));
    throw;
  }
}

std::vector<Argument> plan_arguments(PlanFlags& flags) {
  std::vector<Argument> all{
      scene_argument(flags.scene),
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "folder for the smaller scene.json, certificate.json and index.html; resumes an "
                  "unfinished plan there",
       .value = kFolder},
      {.names = "--tolerance",
       .target = &flags.tolerance,
       .meaning = "largest error of any channel of any pixel, a number or a fraction",
       .value = "X"},
      {.names = "--shift",
       .target = &flags.shift,
       .meaning = "pixels that a point may be out of place; with 0, no edge can meet the tolerance",
       .range = kNotNegative,
       .checked = false},
      {.names = "--in-place",
       .target = &flags.in_place,
       .meaning = "share of the pixels that must meet the tolerance without the shift, as 99%",
       .value = "SHARE"},
      {.names = "--exhaustive",
       .target = &flags.exhaustive,
       .meaning = "measure every choice, to report how close to the best the plan is"},
      {.names = "--rounds",
       .target = &flags.rounds,
       .meaning = "number of rounds; each times every choice",
       .range = Interval<double>{1, 1000}}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand plan_command() {
  const auto flags = std::make_shared<PlanFlags>();
  return {.name = "plan",
          .group = Group::kProve,
          .about = "Find the cheapest model of a scene that meets a tolerance, and prove it",
          .arguments = plan_arguments(*flags),
          .notes =
              "Errors are measured before the picture is rounded to 8 bits. Ctrl-C keeps what was "
              "measured; the same command resumes.\n"
              "Exit code: 0 the tolerance is met, 1 it can't be met, 2 invalid usage or input.",
          .examples = {{"lumaknot plan -o plan/"},
                       {"lumaknot plan scene.json --tolerance 1/255 -o plan/"},
                       {"lumaknot plan scene.json --tolerance 0.02 --shift 0.5 --exhaustive"},
                       {"lumaknot plan scene.json --in-place 99%"}},
          .run = [flags] {
            const InterruptGuard guard;
            return run(*flags);
          }};
}

}  // namespace lumaknot::cli
