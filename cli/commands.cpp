#include "cli/commands.h"

namespace lumaknot {
namespace {

using Describe = Subcommand (*)();

constexpr Describe kCommands[] = {
    scene_command,     mesh_command,  export_command, shader_command,     render_command,
    validate_command,  plan_command,  budget_command, bench_command,      chart_command,
    stability_command, paper_command, doctor_command, completion_command, man_command,
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
              "lumaknot COMMAND --help explains a command, with examples.\n"
              "Exit code: 0 done or agreed, 1 renderers differ or a tolerance can't be met, "
              "2 wrong use or input, 3 nothing to compare with.",
          .examples = {{"lumaknot validate -o report/", "draw Figure 2 everywhere and compare"},
                       {"lumaknot scene figure2 > scene.json"},
                       {"lumaknot render scene.json -o knot.png"},
                       {"lumaknot shader yiq-phong --lang glsl-330 -o out/"}}};
}

std::string_view program_version() { return LUMAKNOT_VERSION; }

}  // namespace lumaknot
