/// The commands, one a file: each adds itself to the program and, when chosen, sets its exit code.
#pragma once

namespace CLI {
class App;
}

namespace lumaknot {

inline constexpr int kExitAgreed = 0, kExitDiffered = 1, kExitWrongUse = 2,
                     kExitNothingToCompare = 3, kExitInterrupted = 130;

struct Programs;

/// Adds the flags that say where the other programs are.
void add_program_flags(CLI::App& command, Programs& programs);

void add_scene_command(CLI::App& program);
void add_mesh_command(CLI::App& program);
void add_render_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_shader_command(CLI::App& program);
void add_validate_command(CLI::App& program, int& exit_code);
void add_bench_command(CLI::App& program);
void add_chart_command(CLI::App& program);
void add_stability_command(CLI::App& program);
void add_budget_command(CLI::App& program);
void add_paper_command(CLI::App& program);
void add_plan_command(CLI::App& program, int& exit_code);
void add_doctor_command(CLI::App& program);
void add_completion_command(CLI::App& program);

/// The program: parses `argv`, runs one command, tells every error in one line. Returns the exit
/// code: 0 done or agreed, 1 renderers differ or a tolerance
/// can't be met, 2 wrong use or input, 3 nothing to compare with.
int run_program(int argc, char** argv);

}  // namespace lumaknot
