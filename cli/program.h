/// The program, without its `main`.
#pragma once

namespace lumaknot::cli {

/// Parses `argv`, runs one command, reports an error in one line. Returns the exit code: 0 success,
/// 1 renderers differ or a tolerance can't be met, 2 invalid usage or input, 3 nothing to compare
/// with, 130 interrupted.
int run_program(int argc, char** argv);

}  // namespace lumaknot::cli
