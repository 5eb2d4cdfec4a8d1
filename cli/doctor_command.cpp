#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/terminal.h"
#include "validate/validate.h"

namespace lumaknot {
namespace {

struct DoctorFlags {
  Programs programs;
  Output out;
};

void run(const DoctorFlags& flags) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& renderer : all_renderers(flags.programs)) {
    const Availability here = renderer->availability();
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

void add_doctor_command(CLI::App& program) {
  auto flags = std::make_shared<DoctorFlags>();
  CLI::App* command =
      program.add_subcommand("doctor", "Tell which renderers are here, and how to get the others");
  add_program_flags(*command, flags->programs);
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n  lumaknot doctor\n  lumaknot doctor --blender /opt/blender-4.2/blender");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
