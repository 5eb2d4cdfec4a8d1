#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"

namespace lumaknot {
namespace {

/// A command's name and its long flags.
struct CommandWords {
  std::string name;
  std::vector<std::string> flags;
};

std::vector<CommandWords> words_of(const CLI::App& program) {
  std::vector<CommandWords> all;
  for (const CLI::App* command : program.get_subcommands({})) {
    CommandWords words{command->get_name(), {}};
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) words.flags.push_back("--" + name);
    }
    all.push_back(words);
  }
  return all;
}

/// Bash's own functions serve zsh too, through bashcompinit.
std::string bash_script(const std::vector<CommandWords>& commands) {
  std::vector<std::string> names;
  std::string cases;
  for (const CommandWords& command : commands) {
    names.push_back(command.name);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name, fmt::join(command.flags, " "));
  }
  return fmt::format(
      "_lumaknot() {{\n"
      "  local words=\"\" current=\"${{COMP_WORDS[COMP_CWORD]}}\"\n"
      "  case \"${{COMP_WORDS[1]}}\" in\n{}  esac\n"
      "  [ \"$COMP_CWORD\" -eq 1 ] && words=\"{}\"\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "}}\n"
      "complete -o default -F _lumaknot lumaknot\n",
      cases, fmt::join(names, " "));
}

std::string fish_script(const std::vector<CommandWords>& commands) {
  std::string text;
  for (const CommandWords& command : commands) {
    text += fmt::format("complete -c lumaknot -n __fish_use_subcommand -f -a {}\n", command.name);
    for (const std::string& flag : command.flags) {
      text += fmt::format("complete -c lumaknot -n '__fish_seen_subcommand_from {}' -l {}\n",
                          command.name, flag.substr(2));
    }
  }
  return text;
}

void print_script(const CLI::App& program, const std::string& shell) {
  const std::vector<CommandWords> commands = words_of(program);
  if (shell == "fish") {
    fmt::print("{}", fish_script(commands));
    return;
  }
  if (shell == "zsh") fmt::print("autoload -U +X bashcompinit && bashcompinit\n");
  fmt::print("{}", bash_script(commands));
}

}  // namespace

void add_completion_command(CLI::App& program) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("completion", "Print a shell's completion script");
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer("Example:\n  source <(lumaknot completion bash)");
  command->callback([shell, &program] { print_script(program, *shell); });
}

}  // namespace lumaknot
