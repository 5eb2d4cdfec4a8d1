/// The commands, one a file, and the program that runs them.
#pragma once

#include <string_view>
#include <vector>

#include "cli/command.h"

namespace lumaknot {

inline constexpr int kExitAgreed = 0, kExitDiffered = 1, kExitWrongUse = 2,
                     kExitNothingToCompare = 3, kExitInterrupted = 130;

Subcommand scene_command();
Subcommand mesh_command();
Subcommand export_command();
Subcommand shader_command();
Subcommand render_command();
Subcommand validate_command();
Subcommand plan_command();
Subcommand budget_command();
Subcommand bench_command();
Subcommand chart_command();
Subcommand stability_command();
Subcommand paper_command();
Subcommand doctor_command();
Subcommand completion_command();
Subcommand man_command();

/// Every command, in the order of the help.
std::vector<Subcommand> all_commands();

/// The program itself: what it is for, its examples and exit codes.
Subcommand program_command();

/// "0.1.0"
std::string_view program_version();

/// The program: parses `argv`, runs one command, reports every error in one line. Returns the exit
/// code: 0 done or agreed, 1 renderers differ or a tolerance
/// can't be met, 2 wrong use or input, 3 nothing to compare with.
int run_program(int argc, char** argv);

}  // namespace lumaknot
