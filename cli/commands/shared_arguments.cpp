#include "cli/commands/shared_arguments.h"

#include <fmt/format.h>

#include "cli/terminal.h"
#include "scene/presets.h"

namespace lumaknot::cli {
Argument scene_argument(std::string& scene) {
  Argument argument{.names = "scene",
                    .target = &scene,
                    .meaning = "scene file, built-in scene, or - for standard input",
                    .value = kScene,
                    .checked = false};
  for (const NamedScene& known : named_scenes()) argument.choices.emplace_back(known.name);
  return argument;
}

std::vector<Argument> output_arguments(Output& output) {
  return {{.names = "--quiet", .target = &output.quiet, .meaning = "print only errors"},
          {.names = "--json", .target = &output.json, .meaning = "print the result as JSON"}};
}

Argument program_argument(validate::Programs& programs, const validate::ProgramInfo& program) {
  std::string& path = programs.paths[program.flag];
  path = validate::Programs{}.path(program);
  return {.names = std::string(program.flag),
          .target = &path,
          .meaning = std::string(program.meaning),
          .value = kProgram,
          .default_text = std::string(program.place),
          .heading = "External programs"};
}

std::vector<Argument> program_arguments(validate::Programs& programs) {
  std::vector<Argument> all;
  for (const validate::ProgramInfo* program : validate::renderer_programs()) {
    all.push_back(program_argument(programs, *program));
  }
  return all;
}

std::string described_ending(std::string_view ending, std::string_view remark) {
  return remark.empty() ? std::string(ending) : fmt::format("{} ({})", ending, remark);
}

}  // namespace lumaknot::cli
