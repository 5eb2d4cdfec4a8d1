#include <fmt/format.h>

#include "cli/describe/completion.h"
#include "cli/describe/layout.h"

namespace lumaknot::cli {
namespace {

constexpr const char* kHelpers = R"(# fish completion of lumaknot

# Whether the command line has the given command; without an argument, whether it has none yet.
function __lumaknot_command
    set -l words (commandline -opc)
    test "$words[2]" = "$argv[1]"
end

# The words that may continue a comma-separated list.
function __lumaknot_list
    set -l list (string replace -r -- '^--[^=]*=' '' (commandline -ct))
    set -l before (string replace -r -- '[^,]*$' '' $list)
    for word in $argv
        string match -q -- "*,$word,*" ",$before"; or echo $before$word
    end
end

)";

/// Text in single quotes, in which fish only knows the escapes \' and \\.
std::string fish_quoted(std::string_view text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') word += '\\';
    word += c;
  }
  return word + "'";
}

/// The options of `complete` for an argument's value; -f: no files, -F: files, -r: value required.
std::string value_options(const Argument& argument) {
  if (!takes_value(argument)) return " -f";
  std::string needed = is_positional(argument) ? "" : " -r";
  const std::string words = joined(argument.choices, " ");
  switch (completion_of(argument)) {
    case Completion::kNone:
      return needed + " -f";
    case Completion::kWords:
      return fmt::format("{} -f -a {}", needed, fish_quoted(words));
    case Completion::kList:
      return fmt::format("{} -f -a '(__lumaknot_list {})'", needed, words);
    case Completion::kFiles:
      return needed + " -F";
    case Completion::kFolders:
      return needed + " -f -a '(__fish_complete_directories)'";
    case Completion::kPrograms:
      return needed + " -F -a '(__fish_complete_command)'";
    case Completion::kScenes:
      return fmt::format("{} -F -a {}", needed, fish_quoted(words));
  }
  return needed;
}

std::string name_options(const Argument& argument) {
  if (is_positional(argument)) return "";
  std::string text;
  for (const std::string& name : names_of(argument)) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return text;
}

std::string line(const Subcommand& command, const Argument& argument) {
  const std::string about = is_positional(argument) ? placeholder(argument) : brief(argument);
  return fmt::format("complete -c lumaknot -n '__lumaknot_command {}'{}{} -d {}\n", command.name,
                     name_options(argument), value_options(argument), fish_quoted(about));
}

}  // namespace

std::string fish_completion(const Subcommand& program, std::span<const Subcommand> commands) {
  std::string text = kHelpers;
  text += "complete -c lumaknot -f\ncomplete -c lumaknot -s h -l help -d 'print help'\n";
  for (const Subcommand& command : commands) {
    text += fmt::format("complete -c lumaknot -n __lumaknot_command -f -a {} -d {}\n", command.name,
                        fish_quoted(command.about));
  }
  for (const Argument& argument : program.arguments) {
    if (!is_positional(argument)) text += line(program, argument);
  }
  for (const Subcommand& command : commands) {
    for (const Argument& argument : command.arguments) text += line(command, argument);
  }
  return text;
}

}  // namespace lumaknot::cli
