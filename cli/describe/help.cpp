#include "cli/describe/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cli/describe/layout.h"

namespace lumaknot::cli {
namespace {

constexpr std::size_t kMaxChoices = 12;  // longer lists are left to completion and --list

std::string range_text(const Interval<double>& range) {
  if (range.max < std::numeric_limits<double>::max()) {
    return fmt::format("{} to {}", range.min, range.max);
  }
  return fmt::format("{} {}", range.open_min ? "above" : "at least", range.min);
}

std::string capitalized(std::string_view text) {
  std::string all(text);
  if (!all.empty() && all[0] >= 'a' && all[0] <= 'z') all[0] = char(all[0] - 'a' + 'A');
  return all;
}

/// The column in which meanings begin.
int column(int width) { return width < 60 ? 10 : 28; }

std::string argument_rows(const std::vector<Argument>& arguments, int width) {
  std::string text;
  for (const Argument& argument : arguments) {
    const bool has_short = argument.names.size() > 1 && argument.names[1] != '-';
    const std::string indent = is_positional(argument) || has_short ? "" : "    ";
    text += row(indent + label(argument), explained(argument), column(width), width);
  }
  return text;
}

std::string example_rows(const std::vector<Example>& examples, int width) {
  std::size_t left = 0, right = 0;
  for (const Example& example : examples) {
    if (!example.meaning.empty()) left = std::max(left, example.line.size());
    right = std::max(right, example.meaning.size());
  }
  const bool side_by_side = 2 + left + 2 + right <= std::size_t(width);
  std::string text = "\nExamples:\n";
  for (const Example& example : examples) {
    if (side_by_side && 2 + int(example.line.size()) <= width) {
      text += row(std::string(example.line), example.meaning, int(left) + 4, width);
      continue;
    }
    text += command_line(example.line, width);
    if (!example.meaning.empty()) text += paragraph(example.meaning, 6, width);
  }
  return text;
}

std::string tail(const Subcommand& command, int width) {
  std::string text = example_rows(command.examples, width);
  if (command.notes.empty()) return text;
  return fmt::format("{}\n{}", text, paragraph(command.notes, 0, width));
}

}  // namespace

std::string usage(const Subcommand& command) {
  std::string text = fmt::format("lumaknot {} [OPTIONS]", command.name);
  for (const Argument& argument : command.arguments) {
    if (is_positional(argument) || !argument.required) continue;
    text += fmt::format(" {} {}", names_of(argument).front(), placeholder(argument));
  }
  for (const Argument& argument : command.arguments) {
    if (!is_positional(argument)) continue;
    const std::string word = placeholder(argument) + (is_repeatable(argument) ? "..." : "");
    text += argument.required ? " " + word : fmt::format(" [{}]", word);
  }
  return text;
}

std::string label(const Argument& argument) {
  if (is_positional(argument)) return placeholder(argument);
  std::string names = joined(names_of(argument), ", ");
  if (!takes_value(argument)) return names;
  const std::string value = placeholder(argument);
  return names + " " + (argument.when_alone.empty() ? value : "[" + value + "]");
}

std::string explained(const Argument& argument) {
  std::vector<std::string> facts;
  if (argument.required) facts.emplace_back("required");
  if (!argument.choices.empty() && argument.choices.size() <= kMaxChoices) {
    facts.push_back(joined(argument.choices, ", "));
  }
  if (argument.range) facts.push_back(range_text(*argument.range));
  if (!argument.when_alone.empty()) {
    facts.push_back(fmt::format("{} if {} is omitted", argument.when_alone, placeholder(argument)));
  }
  if (const std::string value = default_of(argument); !value.empty()) {
    facts.push_back(fmt::format("default: {}", value));
  }
  if (is_repeatable(argument) && !argument.list && !is_positional(argument)) {
    facts.emplace_back("may be repeated");
  }
  if (!argument.needs.empty()) facts.push_back(fmt::format("needs {}", argument.needs));
  if (!argument.excludes.empty()) facts.push_back("not with " + joined(argument.excludes, ", "));
  const std::string meaning = capitalized(argument.meaning);
  return facts.empty() ? meaning : fmt::format("{} [{}]", meaning, joined(facts, "; "));
}

std::vector<Section> sections(const Subcommand& command) {
  std::vector<Section> all;
  for (const Argument& argument : command.arguments) {
    const std::string_view heading = is_positional(argument) ? "Arguments" : argument.heading;
    auto section = std::ranges::find(all, heading, &Section::first);
    if (section == all.end()) section = all.insert(all.end(), {heading, {}});
    section->second.push_back(argument);
  }
  auto options = std::ranges::find(all, "Options", &Section::first);
  if (options == all.end()) options = all.insert(all.end(), {"Options", {}});
  options->second.push_back({.names = "-h,--help", .meaning = "print help"});
  return all;
}

std::string program_help(const Subcommand& program, std::span<const Subcommand> commands,
                         int width) {
  std::string text = paragraph(program.about, 0, width);
  text += "\nUsage: lumaknot COMMAND [OPTIONS]\n";
  for (const auto& [group, title] : kGroups) {
    text += fmt::format("\n{}:\n", title);
    for (const Subcommand& command : commands) {
      if (command.group != group) continue;
      text += row(std::string(command.name), command.about, 14, width);
    }
  }
  const std::string options = argument_rows(sections(program).front().second, width);
  return fmt::format("{}\nOptions:\n{}{}", text, options, tail(program, width));
}

std::string command_help(const Subcommand& command, int width) {
  std::string text = fmt::format("{}\n{}", paragraph(command.about, 0, width),
                                 paragraph("Usage: " + usage(command), 0, width));
  for (const auto& [heading, arguments] : sections(command)) {
    text += fmt::format("\n{}:\n", heading) + argument_rows(arguments, width);
  }
  return text + tail(command, width);
}

}  // namespace lumaknot::cli
