#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>

#include "cli/commands.h"
#include "scene/error.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

void tell(std::string message) {
  std::ranges::replace_if(message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  fmt::print(stderr, "lumaknot: {}\n", message);
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program{"Torus-knot test meshes, luma lighting, and proof that renderers agree."};
  program.name("lumaknot");
  program.set_version_flag("--version", "lumaknot " LUMAKNOT_VERSION);
  program.require_subcommand(0, 1);  // none is told below, an unknown one as such
  program.footer(
      "Examples:\n"
      "  lumaknot validate -o report/              draw Figure 2 everywhere and compare\n"
      "  lumaknot scene figure2 > scene.json\n"
      "  lumaknot render scene.json -o knot.png\n"
      "  lumaknot shader yiq-phong --lang glsl-330 -o out/\n"
      "  lumaknot COMMAND --help                   what a command does, with examples");
  int exit_code = kExitAgreed;
  add_scene_command(program);
  add_mesh_command(program);
  add_render_command(program);
  add_export_command(program);
  add_shader_command(program);
  add_validate_command(program, exit_code);
  add_bench_command(program);
  add_chart_command(program);
  add_stability_command(program);
  add_budget_command(program);
  add_paper_command(program);
  add_plan_command(program, exit_code);
  add_doctor_command(program);
  add_completion_command(program);
  try {
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) throw Error("a command is needed; see lumaknot --help");
    return exit_code;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);  // --help, --version
    tell(fmt::format("{}; see lumaknot --help", e.what()));
  } catch (const Error& e) {
    tell(e.what());
  } catch (const Interrupted& e) {
    tell(e.what());
    return kExitInterrupted;
  } catch (const std::bad_alloc&) {
    tell("out of memory; lower segments, sides, width, height or samples");
  } catch (const std::exception& e) {
    tell(e.what());
  }
  return kExitWrongUse;
}

}  // namespace lumaknot
