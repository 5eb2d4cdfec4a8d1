#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/output_folder.h"
#include "cli/describe/man_page.h"
#include "system/atomic_file.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

void write_pages(const fs::path& folder) {
  const OutputFolder output_folder(folder, "lumaknot.1");
  const std::vector<Subcommand> commands = all_commands();
  write_file(folder / "lumaknot.1", program_page(program_command(), commands), "--output");
  for (const Subcommand& command : commands) {
    if (command.group == Group::kHidden) continue;
    write_file(folder / fmt::format("lumaknot-{}.1", command.name), command_page(command),
               "--output");
  }
}

}  // namespace

Subcommand man_command() {
  const auto folder = std::make_shared<std::string>();
  return {.name = "man",
          .group = Group::kHidden,
          .about = "Write the manual pages",
          .arguments = {{.names = "-o,--output",
                         .target = folder.get(),
                         .meaning = "folder for lumaknot.1, lumaknot-mesh.1, ...",
                         .value = kFolder,
                         .required = true}},
          .examples = {{"lumaknot man -o man1/"}},
          .run = [folder] {
            write_pages(*folder);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
