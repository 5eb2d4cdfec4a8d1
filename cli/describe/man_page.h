/// Manual pages, built from the same data as the help.
#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace lumaknot::cli {

/// lumaknot(1) as roff, listing `commands`.
std::string program_page(const Subcommand& program, std::span<const Subcommand> commands);

/// lumaknot-COMMAND(1) as roff.
std::string command_page(const Subcommand& command);

}  // namespace lumaknot::cli
