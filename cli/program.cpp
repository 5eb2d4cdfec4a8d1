#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "cli/command_table.h"
#include "cli/describe/help.h"
#include "cli/describe/layout.h"
#include "cli/parser.h"
#include "system/error.h"
#include "system/process.h"
#include "system/version.h"

namespace lumaknot::cli {
namespace {

void report(std::string message) {
  std::ranges::replace_if(message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  fmt::print(stderr, "lumaknot: {}\n", message);
}

int run(std::vector<std::string> arguments) {
  const std::vector<Subcommand> commands = all_commands();
  const auto [request, command] = parse(commands, std::move(arguments));
  switch (request) {
    case Parsed::Request::kVersion:
      fmt::print("lumaknot {}\n", version());
      return kExitAgreed;
    case Parsed::Request::kHelp:
      fmt::print("{}", command ? command_help(*command, help_width())
                               : program_help(program_command(), commands, help_width()));
      return kExitAgreed;
    case Parsed::Request::kRun:
      if (!command) throw Error("no command given; try lumaknot --help");
      return command->run();
  }
  return kExitWrongUse;
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const Error& e) {
    report(e.what());
  } catch (const Interrupted& e) {
    report(e.what());
    return kExitInterrupted;
  } catch (const std::bad_alloc&) {
    report("out of memory; reduce segments, sides, width, height or samples");
  } catch (const std::exception& e) {
    report(e.what());
  }
  return kExitWrongUse;
}

}  // namespace lumaknot::cli
