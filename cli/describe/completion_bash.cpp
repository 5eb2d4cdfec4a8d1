#include <fmt/format.h>

#include "cli/describe/completion.h"
#include "cli/describe/layout.h"

namespace lumaknot::cli {
namespace {

/// Indexed by Completion: its name in the script.
constexpr const char* kKinds[] = {"nothing", "word", "list", "file", "folder", "program", "scene"};

constexpr const char* kBashFunctions = R"(
# Completes a value; for a list, without the words already in it.
_lumaknot_complete() {
  local kind=$1 words=$2 current=$3 before="" word
  case "$kind" in
    word) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
    list)
      [[ $current == *,* ]] && before="${current%,*},"
      for word in $words; do
        [[ ",$before" != *",$word,"* && $word == "${current##*,}"* ]] && COMPREPLY+=("$before$word")
      done
      compopt -o nospace 2>/dev/null ;;
    file) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    program) mapfile -t COMPREPLY < <(compgen -c -- "$current" | sort -u) ;;
    scene) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; compgen -f -- "$current") ;;
  esac
  case "$kind" in file|folder|program|scene) compopt -o filenames -o default 2>/dev/null ;; esac
}

_lumaknot() {
  local command=${COMP_WORDS[1]} current=${COMP_WORDS[COMP_CWORD]} flag=${COMP_WORDS[COMP_CWORD-1]}
  local kind="" words=""
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    command="" flag=""
  elif [[ $current == "=" ]]; then  # bash splits --flag=value
    current=""
  elif [[ $flag == "=" ]]; then
    flag=${COMP_WORDS[COMP_CWORD-2]}
  fi
  if [[ $current != -* ]]; then
    _lumaknot_describe "$command" "$flag"
    [[ $kind ]] || _lumaknot_describe "$command" argument
  fi
  [[ $kind ]] || _lumaknot_describe "$command" flags
  _lumaknot_complete "$kind" "$words" "$current"
}
complete -F _lumaknot lumaknot
)";

/// "'mesh -o'|'mesh --output'"
std::string pattern(const Subcommand& command, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += fmt::format("{}'{} {}'", text.empty() ? "" : "|", command.name, name);
  }
  return text;
}

std::string entry(const Argument& argument, const std::string& pattern) {
  std::string text = fmt::format("    {}) kind={}", pattern, kKinds[int(completion_of(argument))]);
  if (!argument.choices.empty()) text += " words=" + single_quoted(joined(argument.choices, " "));
  return text + " ;;\n";
}

/// What may follow each word of a command.
std::string entries(const Subcommand& command) {
  std::string text;
  Argument flags{.names = "flags", .target = Take<std::string>(), .choices = {"--help"}};
  for (const Argument& argument : command.arguments) {
    const bool is_flag = !is_positional(argument);
    const std::vector<std::string> names =
        is_flag ? names_of(argument) : std::vector<std::string>{"argument"};
    if (is_flag) flags.choices.insert(flags.choices.end(), names.begin(), names.end());
    if (takes_value(argument)) text += entry(argument, pattern(command, names));
  }
  return text + entry(flags, pattern(command, {"flags"}));
}

}  // namespace

std::string bash_completion(const Subcommand& program, std::span<const Subcommand> commands) {
  Subcommand first = program;  // the command is its positional argument
  Argument name{.names = "command", .target = Take<std::string>()};
  for (const Subcommand& command : commands) name.choices.emplace_back(command.name);
  first.arguments.push_back(name);
  std::string cases = entries(first);
  for (const Subcommand& command : commands) cases += entries(command);
  return fmt::format(
      "# bash completion of lumaknot\n\n"
      "# Sets kind and words to what may follow a word of a command.\n"
      "_lumaknot_describe() {{\n  case \"$1 $2\" in\n{}  esac\n}}\n{}",
      cases, kBashFunctions);
}

}  // namespace lumaknot::cli
