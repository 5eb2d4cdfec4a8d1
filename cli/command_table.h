/// The commands, one per file.
#pragma once

#include <vector>

#include "cli/command.h"

namespace lumaknot::cli {

inline constexpr int kExitAgreed = 0, kExitDiffered = 1, kExitWrongUse = 2,
                     kExitNothingToCompare = 3, kExitInterrupted = 130;

Subcommand scene_command();
Subcommand mesh_command();
Subcommand export_command();
Subcommand shader_command();
Subcommand render_command();
Subcommand validate_command();
Subcommand why_command();
Subcommand diagnose_command();
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

/// The program itself: its purpose, examples and exit codes.
Subcommand program_command();

}  // namespace lumaknot::cli
