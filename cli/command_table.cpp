#include "cli/command_table.h"

namespace lumaknot::cli {
namespace {

using Describe = Subcommand (*)();

constexpr Describe kCommands[] = {
    scene_command,      mesh_command,  export_command,    shader_command, render_command,
    validate_command,   why_command,   diagnose_command,  plan_command,   budget_command,
    bench_command,      chart_command, stability_command, paper_command,  doctor_command,
    completion_command, man_command,
};

}  // namespace

std::vector<Subcommand> all_commands() {
  std::vector<Subcommand> all;
  for (const Describe describe : kCommands) all.push_back(describe());
  return all;
}

Subcommand program_command() {
  return {.name = "",
          .about = "Torus-knot test meshes, luma lighting, and proof that renderers agree",
          .arguments = {{.names = "--version", .meaning = "print the version"}},
          .notes =
              "Run lumaknot COMMAND --help for the options and examples of a command.\n"
              "Exit code: 0 success, 1 renderers differ or a tolerance can't be met, "
              "2 invalid usage or input, 3 nothing to compare with, 130 interrupted.",
          .examples = {{"lumaknot validate -o report/", "compare all renderers on Figure 2"},
                       {"lumaknot scene figure2 > scene.json"},
                       {"lumaknot render scene.json -o knot.png"},
                       {"lumaknot shader yiq-phong --lang glsl-330 -o out/"}}};
}

}  // namespace lumaknot::cli
