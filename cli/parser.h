/// Parses the command line as the commands describe themselves.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/command.h"

namespace lumaknot::cli {

/// What the command line asks for.
struct Parsed {
  enum class Request { kRun, kHelp, kVersion };
  Request request = Request::kRun;
  const Subcommand* command = nullptr;  ///< among those parsed; null: the program itself
};

/// Reads `arguments`, without the program's name, into the targets of the command they name.
/// Throws Error for anything unexpected.
Parsed parse(std::span<const Subcommand> commands, std::vector<std::string> arguments);

}  // namespace lumaknot::cli
