#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command_table.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "validate/renderers/entry.h"

namespace lumaknot::cli {
namespace {

struct DoctorFlags {
  validate::Programs programs;
  Output out;
};

void run(const DoctorFlags& flags) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    const std::unique_ptr<validate::Renderer> renderer = entry->make(flags.programs);
    const validate::Availability here = renderer->availability();
    json.push_back({{"renderer", renderer->name()},
                    {"found", here.found},
                    {"version", here.version},
                    {"path", here.path},
                    {"remedy", here.remedy}});
    flags.out.say(
        here.found ? fmt::format("{:<8} found    {}  {}", renderer->name(), here.version, here.path)
                   : fmt::format("{:<8} missing  {}", renderer->name(), here.remedy));
  }
  if (flags.out.json) fmt::print("{}\n", json.dump(2));
}

}  // namespace

Subcommand doctor_command() {
  const auto flags = std::make_shared<DoctorFlags>();
  Subcommand command{
      .name = "doctor",
      .group = Group::kSetUp,
      .about = "Report which renderers are installed and how to get the others",
      .arguments = output_arguments(flags->out),
      .examples = {{"lumaknot doctor"}, {"lumaknot doctor --blender /opt/blender-4.2/blender"}},
      .run = [flags] {
        run(*flags);
        return kExitAgreed;
      }};
  append(command.arguments, program_arguments(flags->programs));
  return command;
}

}  // namespace lumaknot::cli
