#include <fmt/format.h>

#include <memory>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "exporters/image/file.h"
#include "study/budget/stages.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

struct BudgetFlags {
  std::string scene = "figure2", picture;
  budget::BudgetOptions options;
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
  const budget::ErrorBudget budget = budget::error_budget(load_scene(input), *knot, flags.options,
                                                          progress_bar(flags.out, "budget"));
  if (!flags.picture.empty())
    write_image(flags.picture, budget::budget_picture(budget), "--output");
  if (flags.out.json) fmt::print("{}", budget::budget_json(budget));
  flags.out.say(budget::budget_text(budget));
}

std::vector<Argument> budget_arguments(BudgetFlags& flags) {
  std::vector<Argument> all{
      scene_argument(flags.scene),
      {.names = "-o,--output",
       .target = &flags.picture,
       .meaning = "draw the errors times 16, four per row: the total, each stage, the remainder "
                  "(.png or .exr)",
       .value = kFile},
      {.names = "--samples",
       .target = &flags.options.samples,
       .meaning = "use N x N samples per pixel for the stages whose exact form is a mean",
       .range = Interval<double>{2, 32}},
      {.names = "--tolerance",
       .target = &flags.options.tolerance,
       .meaning = "estimated error per pixel of the truth the image is compared with",
       .range = Interval<double>{1e-6, 1.0}}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand budget_command() {
  const auto flags = std::make_shared<BudgetFlags>();
  return {.name = "budget",
          .group = Group::kProve,
          .about = "Report how much of an image's error each stage causes",
          .arguments = budget_arguments(*flags),
          .examples = {{"lumaknot budget"},
                       {"lumaknot budget scene.json --json"},
                       {"lumaknot budget figure1-back -o budget.png"}},
          .run = [flags] {
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
