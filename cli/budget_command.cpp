#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "exporters/image_file.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "study/error_budget.h"

namespace lumaknot {
namespace {

struct BudgetFlags {
  std::string scene = "figure2", picture;
  BudgetOptions options;
  Output out;
};

void run(const BudgetFlags& flags) {
  if (!flags.picture.empty()) {
    check_image_extension(flags.picture, "--output");
    check_writable(flags.picture, "--output");
  }
  const SceneInput input = read_scene(flags.scene);
  if (!flags.picture.empty()) check_not_input(flags.picture, input, "--output");
  const auto* knot = std::get_if<KnotSpec>(&input.spec.mesh);
  if (!knot) throw Error("a budget needs mesh.knot: a mesh file has no exact surface");
  const ErrorBudget budget =
      error_budget(load_scene(input), *knot, flags.options, progress_bar(flags.out, "budget"));
  if (!flags.picture.empty()) write_image(flags.picture, budget_picture(budget), "--output");
  if (flags.out.json) fmt::print("{}", budget_json(budget));
  flags.out.say(budget_text(budget));
}

}  // namespace

void add_budget_command(CLI::App& program) {
  auto flags = std::make_shared<BudgetFlags>();
  CLI::App* command =
      program.add_subcommand("budget", "Tell which stage makes how much of an image's error");
  command->add_option("scene", flags->scene, "scene file, built-in scene, or -")
      ->capture_default_str();
  command
      ->add_option("--samples", flags->options.samples,
                   "n x n samples a pixel, for the stages whose exact form is a mean")
      ->check(CLI::Range(2, 32))
      ->capture_default_str();
  command
      ->add_option("--tolerance", flags->options.tolerance,
                   "of the truth that the image is held to: a pixel's error, as estimated")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  command->add_option("-o,--output", flags->picture,
                      "the errors of the whole, of each stage and left over, x 16, four a row: "
                      ".png or .exr");
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot budget\n"
      "  lumaknot budget scene.json --json\n"
      "  lumaknot budget figure1-back -o budget.png");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
