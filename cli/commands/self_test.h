/// `lumaknot validate --self-test`.
#pragma once

#include <string>
#include <vector>

#include "cli/commands/scene_input.h"
#include "cli/terminal.h"
#include "validate/renderers/programs.h"

namespace lumaknot::cli {

/// Plants faults in the scene and in its pictures, and writes self-test.md into the folder
/// `output`. Returns the exit code.
int run_self_test_command(const SceneInput& input, const std::vector<std::string>& renderers,
                          const validate::Programs& programs, const std::string& output,
                          const Output& out);

}  // namespace lumaknot::cli
