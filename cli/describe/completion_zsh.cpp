#include <fmt/format.h>

#include "cli/describe/completion.h"
#include "cli/describe/layout.h"

namespace lumaknot::cli {
namespace {

constexpr const char* kZshFunctions = R"(
_lumaknot_scenes() {
  local -a scenes=($@)
  _alternative 'scenes:built-in scene:compadd -a scenes' 'files:scene file:_files'
}

_lumaknot_programs() {
  _command_names -e || _files
}

# Sourced, this file defines the completion; found in $fpath, it is the completion.
if [[ ${funcstack[1]} == _lumaknot ]]; then
  _lumaknot "$@"
else
  (( $+functions[compdef] )) || { autoload -Uz compinit && compinit }
  compdef _lumaknot lumaknot
fi
)";

/// `text` for a specification of _arguments, with the separators in `divide` escaped.
std::string escaped(std::string_view text, std::string_view divide) {
  std::string all;
  for (const char c : text) {
    if (divide.find(c) != std::string_view::npos) all += '\\';
    all += c;
  }
  return all;
}

/// The action of _arguments that completes a value.
std::string action(const Argument& argument) {
  const std::string words = joined(argument.choices, " ");
  switch (completion_of(argument)) {
    case Completion::kNone:
      return " ";
    case Completion::kWords:
      return fmt::format("({})", words);
    case Completion::kList:
      return fmt::format(" _values -s , value {}", words);
    case Completion::kFiles:
      return "_files";
    case Completion::kFolders:
      return "_files -/";
    case Completion::kPrograms:
      return "_lumaknot_programs";
    case Completion::kScenes:
      return fmt::format(" _lumaknot_scenes {}", words);
  }
  return " ";
}

std::string value_spec(const Argument& argument) {
  return fmt::format(":{}:{}", escaped(placeholder(argument), ":"), action(argument));
}

std::string positional_spec(const Argument& argument) {
  return fmt::format("{}{}", is_repeatable(argument) ? "*" : "1", value_spec(argument));
}

/// For one of the flag's names, which excludes the others.
std::string flag_spec(const Argument& argument, const std::string& name) {
  std::string spec = is_repeatable(argument) && !argument.list
                         ? "*"
                         : fmt::format("({})", joined(names_of(argument), " "));
  spec += name;
  const bool optional = !argument.when_alone.empty();
  if (takes_value(argument)) spec += name.starts_with("--") ? "=" : "+";
  spec += fmt::format("[{}]", escaped(brief(argument), "[]\\"));
  if (!takes_value(argument)) return spec;
  return fmt::format("{}{}{}", spec, optional ? ":" : "", value_spec(argument));
}

/// The call of _arguments for a command's flags and positional arguments.
std::string arguments_call(const Subcommand& command) {
  std::string call = "_arguments '(- *)'{-h,--help}'[print help]'";
  for (const Argument& argument : command.arguments) {
    const std::vector<std::string> names = names_of(argument);
    for (const std::string& name : names) {
      const std::string spec =
          is_positional(argument) ? positional_spec(argument) : flag_spec(argument, name);
      call += " \\\n        " + single_quoted(spec);
    }
  }
  return call;
}

std::string described(std::span<const Subcommand> commands) {
  std::string lines;
  for (const Subcommand& command : commands) {
    lines +=
        fmt::format("    {}\n", single_quoted(fmt::format("{}:{}", command.name, command.about)));
  }
  return lines;
}

}  // namespace

std::string zsh_completion(const Subcommand&, std::span<const Subcommand> commands) {
  std::string cases;
  for (const Subcommand& command : commands) {
    cases += fmt::format("      {})\n        {} ;;\n", command.name, arguments_call(command));
  }
  return fmt::format(
      "#compdef lumaknot\n\n"
      "_lumaknot() {{\n"
      "  local curcontext=$curcontext state line\n"
      "  typeset -A opt_args\n"
      "  local -a known=(\n{}  )\n"
      "  _arguments -C '(- *)'{{-h,--help}}'[print help]' '(- *)--version[print the version]' \\\n"
      "    '1:command:->command' '*::argument:->arguments'\n"
      "  case $state in\n"
      "    command) _describe -V command known ;;\n"
      "    arguments) case $words[1] in\n{}    esac ;;\n"
      "  esac\n}}\n{}",
      described(commands), cases, kZshFunctions);
}

}  // namespace lumaknot::cli
