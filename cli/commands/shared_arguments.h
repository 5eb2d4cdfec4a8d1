/// Arguments that several commands share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "validate/renderers/entry.h"

namespace lumaknot::cli {

struct Output;

/// The scene to work on: a file, a built-in scene or standard input.
Argument scene_argument(std::string& scene);

/// --quiet and --json.
std::vector<Argument> output_arguments(Output& output);

/// The path of an external program.
Argument program_argument(validate::Programs& programs, const validate::ProgramInfo& program);

/// The paths of all that renderers run.
std::vector<Argument> program_arguments(validate::Programs& programs);

/// ".py (Blender script)": how a flag's meaning lists a file's ending.
std::string described_ending(std::string_view ending, std::string_view remark);

}  // namespace lumaknot::cli
