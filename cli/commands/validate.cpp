#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/allowance_flag.h"
#include "cli/commands/limit_flags.h"
#include "cli/commands/noise_flags.h"
#include "cli/commands/output_folder.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/self_test.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "scene/check.h"
#include "scene/presets.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/known.h"
#include "system/process.h"
#include "validate/noise.h"
#include "validate/renderers/entry.h"
#include "validate/report/forms.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

constexpr long long kMaxSamples = 1LL << 24;  // each takes about 600 bytes

struct ValidateFlags {
  std::string scene = "figure2", output = "report";
  std::string junit;
  std::vector<std::string> models, renderers, allowed;
  LimitFlags limits;
  validate::Programs programs;
  double time_limit = 300;
  bool self_test = false;
  NoiseFlags noise;
  Output out;
};

/// The materials to draw: those named, or the scene's own and the paper's three.
std::vector<Shot> finals(const Material& own, const std::vector<std::string>& models) {
  std::vector<Shot> shots;
  if (models.empty()) {
    const auto is_own = [&](const NamedMaterial& m) { return m.name == formula_name(own); };
    if (std::ranges::none_of(paper_materials(), is_own)) {
      shots.push_back({"scene", Stage::kFinal, own});
    }
    for (const NamedMaterial& m : paper_materials()) {
      shots.push_back({std::string(m.name), Stage::kFinal, known(with_formula(own, m.name))});
    }
  }
  for (const std::string& name : models) {
    if (std::ranges::count(shots, name, &Shot::name) > 0) continue;
    shots.push_back({name, Stage::kFinal, name == "scene" ? own : known(with_formula(own, name))});
  }
  return shots;
}

/// `text` quoted as one word for a shell.
std::string shell_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_-./:=,%").find(char(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string repeat_command(const ValidateFlags& flags) {
  std::string command = "lumaknot validate " + shell_word(flags.scene);
  const auto add = [&](std::string_view flag, const std::string& value) {
    command += fmt::format(" {} {}", flag, shell_word(value));
  };
  for (const std::string& model : flags.models) add("--model", model);
  for (const std::string& renderer : flags.renderers) add("--renderer", renderer);
  command += repeated(flags.noise);
  for (const std::string& share : flags.allowed) add("--allow", share);
  for (const std::string& limit : flags.limits.values) add("--limit", limit);
  if (!flags.limits.file.empty()) add("--limits", flags.limits.file);
  for (const validate::ProgramInfo* program : validate::renderer_programs()) {
    const std::string path = flags.programs.path(*program);
    if (path != validate::Programs{}.path(*program)) add(program->flag, path);
  }
  add("-o", flags.output);
  return command;
}

/// A line with the outcome of a renderer.
std::string summary(const validate::RendererResult& result) {
  std::string line = fmt::format("{:<8} ", result.rendering.renderer);
  const std::vector<validate::Judged>& shots = result.shots;
  const auto status = [](const validate::Judged& shot) { return shot.drawn.status; };
  auto first = std::ranges::find(shots, validate::RenderedShot::Status::kFailed, status);
  const bool failed = first != shots.end();
  if (!failed) first = std::ranges::find(shots, validate::RenderedShot::Status::kSkipped, status);
  if (failed || !result.drew_any()) {
    return line + fmt::format("{}: {}", validate::outcome(*first), first->drawn.why);
  }
  line += validate::outcome_name(result.outcome());
  if (!result.first_difference.empty()) {
    line += fmt::format(", first in: {}", result.first_difference);
  } else if (!result.explained.empty()) {
    line += ": " + validate::explanation(result.explained);
  }
  if (!result.coverage_note.empty()) line += "; " + result.coverage_note;
  const auto count = std::ranges::count(shots, validate::RenderedShot::Status::kSkipped, status);
  if (count > 0) line += fmt::format("; {} skipped: {}", count, first->drawn.why);
  if (!result.cause.empty()) line += fmt::format("\n{:9}{}", "", result.cause);
  return line;
}

int exit_code_of(validate::Verdict verdict) {
  if (verdict == validate::Verdict::kAgreed) return kExitAgreed;
  return verdict == validate::Verdict::kNothingToCompare ? kExitNothingToCompare : kExitDiffered;
}

/// Throws Error if a file of the result would overwrite an input.
void check_outputs(const ValidateFlags& flags, const SceneInput& input) {
  for (const char* file : {"report.json", "report.html"}) {
    check_not_input(fs::path(flags.output) / file, input, "--output");
  }
  if (!flags.junit.empty()) check_not_input(flags.junit, input, "--junit");
}

/// Writes the report in all its forms and prints the result.
void write_reports(const ValidateFlags& flags, const validate::Validation& validation) {
  const validate::ReportHead head{flags.scene, repeat_command(flags)};
  const std::string json = validate::report_json(validation, head);
  const fs::path page = fs::path(flags.output) / "report.html";
  write_file(fs::path(flags.output) / "report.json", json, "--output");
  write_file(page, validate::report_html(validation, head), "--output");
  if (!flags.junit.empty()) {
    write_file(flags.junit, validate::report_junit(validation, head), "--junit");
  }
  if (flags.out.json) fmt::print("{}", json);
  for (const validate::RendererResult& result : validation.results) {
    flags.out.say(summary(result));
    const std::string noise = validate::noise_summary(validation, result);
    if (!noise.empty()) flags.out.say(fmt::format("{:9}{}", "", noise));
  }
  flags.out.say(fmt::format("{}: {} in {:.1f} s; see {}", flags.scene,
                            validate::verdict_name(validation.verdict), validation.seconds,
                            page.string()));
}

/// Draws and judges.
validate::Validation validated(const ValidateFlags& flags, validate::ValidationJob job) {
  const bool verbose = isatty(STDERR_FILENO) && !flags.out.quiet;
  const auto on_message = [&](const std::string& line) {
    if (verbose) fmt::print(stderr, "{}\n", line);
  };
  if (!flags.noise.given()) {
    job.scene = validate::sample_by_sample(std::move(job.scene));
    return validate::validate(job, on_message);
  }
  job.scene.view.image.samples = 1;
  return validate::validate_noise(job, sampling_renderer(flags.renderers), flags.noise.sampling,
                                  on_message);
}

int run(const ValidateFlags& flags) {
  const SceneInput input = read_scene(flags.scene);
  check_number("--time-limit", flags.time_limit, kPositive);
  validate::Programs programs = flags.programs;
  programs.time_limit = std::chrono::duration<double>(flags.time_limit);
  if (flags.self_test) {
    return run_self_test_command(input, flags.renderers, programs, flags.output, flags.out);
  }
  check_outputs(flags, input);
  if (flags.noise.given()) {
    sampling_renderer(flags.renderers);
    check_noisy_pixels(input.spec.view.image);
  } else {
    check_samples(input.spec.view.image, kMaxSamples);
  }
  validate::ValidationJob job{load_scene(input),
                              finals(input.spec.view.material, flags.models),
                              flags.renderers,
                              programs,
                              allowances_of(flags.allowed),
                              limits_of(flags.limits)};
  if (const auto* knot = std::get_if<KnotSpec>(&input.spec.mesh)) job.knot = *knot;
  const OutputFolder output_folder(flags.output, "report.html");
  if (!flags.junit.empty()) check_writable(flags.junit, "--junit");
  const validate::Validation validation = validated(flags, std::move(job));
  write_reports(flags, validation);
  return exit_code_of(validation.verdict);
}

std::vector<std::string> model_names() {
  std::vector<std::string> names{"scene"};
  for (const NamedMaterial& m : paper_materials()) names.emplace_back(m.name);
  std::ranges::copy(formula_names(), std::back_inserter(names));
  return names;
}

/// Of all renderers, or only of those that draw by default.
std::vector<std::string> renderer_flags(bool only_default) {
  std::vector<std::string> flags;
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    if (entry->by_default || !only_default) flags.emplace_back(entry->flag);
  }
  return flags;
}

std::vector<Argument> validate_arguments(ValidateFlags& flags) {
  std::vector<Argument> all{
      scene_argument(flags.scene),
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "folder for report.html and report.json",
       .value = kFolder},
      {.names = "--model",
       .target = &flags.models,
       .meaning = "material to draw: scene, one of the paper's (phong, yiq-table1, yiq-eq6), or a "
                  "shader from lumaknot shader --list",
       .default_text = "the scene's own and the paper's",
       .choices = model_names()},
      {.names = "--renderer,--against",
       .target = &flags.renderers,
       .meaning = "renderers to compare",
       .default_text = fmt::format("{}", fmt::join(renderer_flags(true), ",")),
       .choices = renderer_flags(false),
       .list = true},
      allow_argument(flags.allowed),
      {.names = "--junit",
       .target = &flags.junit,
       .meaning = "file for the result as JUnit XML, which build servers read",
       .value = kFile},
      {.names = "--self-test",
       .target = &flags.self_test,
       .meaning = "plant faults in the scene and in its pictures, drawn by lumaknot and by the "
                  "renderers named, and prove that each is noticed and named; writes self-test.md",
       .excludes = {"--model"}},
      {.names = "--time-limit",
       .target = &flags.time_limit,
       .meaning = "seconds a renderer may take",
       .range = kPositive,
       .checked = false}};
  append(all, noise_arguments(flags.noise));
  append(all, limit_arguments(flags.limits));
  append(all, output_arguments(flags.out));
  append(all, program_arguments(flags.programs));
  return all;
}

}  // namespace

Subcommand validate_command() {
  const auto flags = std::make_shared<ValidateFlags>();
  return {
      .name = "validate",
      .group = Group::kProve,
      .about = "Draw a scene with every renderer and prove whether they agree",
      .arguments = validate_arguments(*flags),
      .notes =
          "A renderer agrees, differs, or is explained: each difference has a known cause that was "
          "recomputed, but more of the picture differs than is allowed.\n"
          "With --noise, a renderer differs if both of its pictures are off on the same side, in a "
          "pixel, a block of pixels or as a whole, by more than its noise admits: a renderer that "
          "is right is found to differ with a chance of 0.001.\n"
          "Exit code: 0 all agree, 1 one differs, is explained or fails, 2 invalid usage or input, "
          "3 nothing to compare with.",
      .examples = {{"lumaknot validate -o report/"},
                   {"lumaknot validate scene.json --model scene --renderer povray -o report/"},
                   {"lumaknot validate --allow turned-normal=20% --junit tests.xml"},
                   {"lumaknot validate --model cielab-cook-torrance --against gl,vulkan"},
                   {"lumaknot validate scene.json --renderer cycles --noise 64 -o report/",
                    "as its users draw it, judged by statistics"},
                   {"lumaknot validate scene.json --self-test --renderer gl -o self-test/"},
                   {"lumaknot validate figure1-back --blender /opt/blender-4.2/blender"}},
      .run = [flags] {
        const InterruptGuard guard;
        return run(*flags);
      }};
}

}  // namespace lumaknot::cli
