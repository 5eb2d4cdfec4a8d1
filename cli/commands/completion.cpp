#include "cli/describe/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "cli/command_table.h"

namespace lumaknot::cli {
namespace {

struct Shell {
  const char* name;
  std::string (*script)(const Subcommand& program, std::span<const Subcommand> commands);
};
constexpr Shell kShells[] = {
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

void print_script(const std::string& shell) {
  std::vector<Subcommand> commands = all_commands();
  std::erase_if(commands, [](const Subcommand& c) { return c.group == Group::kHidden; });
  const auto* found = std::ranges::find(kShells, shell, &Shell::name);
  fmt::print("{}", found->script(program_command(), commands));
}

std::vector<std::string> shell_names() {
  std::vector<std::string> names;
  std::ranges::transform(kShells, std::back_inserter(names), &Shell::name);
  return names;
}

}  // namespace

Subcommand completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {.name = "completion",
          .group = Group::kSetUp,
          .about = "Print a shell completion script",
          .arguments = {{.names = "shell",
                         .target = shell.get(),
                         .meaning = "shell to generate the script for",
                         .value = "SHELL",
                         .choices = shell_names(),
                         .required = true}},
          .notes =
              "zsh also finds the script as a file _lumaknot in a folder on $fpath, and fish as "
              "lumaknot.fish in ~/.config/fish/completions.",
          .examples = {{"source <(lumaknot completion bash)", "in ~/.bashrc"},
                       {"source <(lumaknot completion zsh)", "in ~/.zshrc, after compinit"},
                       {"lumaknot completion fish | source", "in ~/.config/fish/config.fish"}},
          .run = [shell] {
            print_script(*shell);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
