#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/output_folder.h"
#include "cli/scene_input.h"
#include "cli/shared_arguments.h"
#include "cli/terminal.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/scene_json.h"
#include "study/planning/plan.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

struct PlanFlags {
  std::string scene = "figure2", output = "plan", tolerance = "1/255";
  double shift = Tolerance{}.shift;
  bool exhaustive = false;
  int rounds = 5;
  Output out;
};

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

/// "0.004", or a fraction of a number > 0: "1/255".
double tolerance_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto above = number_of(std::string_view(text).substr(0, slash));
  const auto below =
      slash == std::string::npos ? 1 : number_of(std::string_view(text).substr(slash + 1));
  if (above && below && *below > 0) return *above / *below;
  throw Error(
      fmt::format("--tolerance must be a number or a fraction > 0, got {}; say 1/255", text));
}

/// The name of the texture's copy.
std::string texture_name(const TextureFile& file) {
  return "texture" + fs::path(file.path).extension().string();
}

void check_spares_inputs(const SceneInput& input, const fs::path& folder) {
  std::vector<std::string> names{"scene.json", "certificate.json", "index.html", "measured.json"};
  if (const auto* file = std::get_if<TextureFile>(&input.spec.texture)) {
    names.push_back(texture_name(*file));
  }
  for (const std::string& name : names) check_not_input(folder / name, input, "--output");
}

/// The texture's file beside the smaller scene, which is read from there.
void copy_texture(const SceneInput& input, const fs::path& folder, SceneSpec& lean) {
  auto* file = std::get_if<TextureFile>(&lean.texture);
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

void write_all(const SceneInput& input, Plan& plan, const PlanFlags& flags) {
  const fs::path folder = flags.output;
  const std::string command =
      fmt::format("lumaknot render {}{} -o planned.png", (folder / "scene.json").string(),
                  joined(render_arguments(plan.chosen.method)));
  copy_texture(input, folder, plan.lean);
  write_file(folder / "scene.json", scene_to_json(plan.lean), "--output");
  write_file(folder / "certificate.json", plan_json(plan), "--output");
  write_file(folder / "index.html", plan_html(plan, flags.scene, command), "--output");
  if (flags.out.json) fmt::print("{}", plan_json(plan));
  flags.out.say(plan_text(plan));
  flags.out.say(fmt::format("draw it: {}", command));
  flags.out.say(fmt::format("see {}", (folder / "index.html").string()));
}

std::string where_it_stands(const PlanJob& job, const std::string& folder) {
  const std::size_t kept = measured_choices(job, folder);
  if (kept == 0) return "interrupted; nothing is kept yet";
  return fmt::format(
      "interrupted; {} choices are measured and kept in {}; the same command goes on", kept,
      folder);
}

int run(const PlanFlags& flags) {
  const Tolerance tolerance{tolerance_of(flags.tolerance), flags.shift};
  check_tolerance(tolerance, false);
  const SceneInput input = read_scene(flags.scene);
  check_spares_inputs(input, flags.output);
  const PlanJob job{load_scene(input), input.spec, tolerance, flags.exhaustive, flags.rounds};
  check_plan(job);
  const OutputFolder made(flags.output, "scene.json");
  try {
    Plan plan =
        make_plan(job, flags.output, progress_bar(flags.out, "plan"),
                  [](const std::string& line) { fmt::print(stderr, "lumaknot: {}\n", line); });
    write_all(input, plan, flags);
    return plan.met ? kExitAgreed : kExitDiffered;
  } catch (const Interrupted&) {  // told here: what interrupted it ends the program soon
    fmt::print(stderr, "lumaknot: {}\n", where_it_stands(job, flags.output));
    throw;
  }
}

std::vector<Argument> plan_arguments(PlanFlags& flags) {
  std::vector<Argument> all{
      scene_argument(flags.scene),
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "the folder for the smaller scene.json, certificate.json and index.html; a plan "
                  "begun there is resumed",
       .value = kFolder},
      {.names = "--tolerance",
       .target = &flags.tolerance,
       .meaning = "of each channel of each pixel, a number or a fraction",
       .value = "X"},
      {.names = "--shift",
       .target = &flags.shift,
       .meaning = "pixels within which the truth may show what the picture shows; with 0 no edge "
                  "can be met",
       .range = kNotNegative,
       .checked = false},
      {.names = "--exhaustive",
       .target = &flags.exhaustive,
       .meaning = "measure every choice, to report how close to the best the plan is"},
      {.names = "--rounds",
       .target = &flags.rounds,
       .meaning = "rounds that time a choice",
       .range = Bound{1, 1000}}};
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
              "Errors are of the picture before it is rounded to 8 bits. Ctrl-C keeps what "
              "was measured; the same command resumes.\n"
              "Exit code: 0 the tolerance is met, 1 it can't be met, 2 wrong use or input.",
          .examples = {{"lumaknot plan -o plan/"},
                       {"lumaknot plan scene.json --tolerance 1/255 -o plan/"},
                       {"lumaknot plan scene.json --tolerance 0.02 --shift 0.5 --exhaustive"}},
          .run = [flags] {
            const InterruptGuard guard;
            return run(*flags);
          }};
}

}  // namespace lumaknot
