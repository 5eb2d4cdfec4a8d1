/// The program, without its `main`.
#pragma once

namespace lumaknot {

/// Parses `argv`, runs one command, reports every error in one line. Returns the exit code: 0 done
/// or agreed, 1 renderers differ or a tolerance can't be met, 2 wrong use or input, 3 nothing to
/// compare with.
int run_program(int argc, char** argv);

}  // namespace lumaknot
