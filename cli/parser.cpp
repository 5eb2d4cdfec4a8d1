// The only file that includes CLI11, which takes longer to compile than the rest of cli/.
#include "cli/parser.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "system/error.h"

namespace lumaknot::cli {
namespace {

/// Adds an argument by the type of its target.
struct Adder {
  CLI::App& app;
  const Argument& argument;

  CLI::Option* operator()(bool* target) const { return app.add_flag(argument.names, *target); }
  template <class T>
  CLI::Option* operator()(T* target) const {
    return app.add_option(argument.names, *target);
  }
  template <class T>
  CLI::Option* operator()(const Take<T>& take) const {
    return app.add_option_function<T>(argument.names, take);
  }
};

bool takes_int(const Argument& argument) {
  return std::holds_alternative<int*>(argument.target) ||
         std::holds_alternative<std::vector<int>*>(argument.target);
}

CLI::Validator member_of(const Argument& argument) {
  if (!takes_int(argument)) return CLI::IsMember(argument.choices);
  std::vector<int> numbers;
  numbers.reserve(argument.choices.size());
  for (const std::string& choice : argument.choices) numbers.push_back(std::stoi(choice));
  return CLI::IsMember(numbers);
}

CLI::Validator within(const Argument& argument, const Interval<double>& range) {
  if (range.open_min) return CLI::PositiveNumber;
  if (takes_int(argument)) return CLI::Range(int(range.min), int(range.max));
  return CLI::Range(range.min, range.max);
}

void add(CLI::App& app, const Argument& argument) {
  CLI::Option* option = std::visit(Adder{app, argument}, argument.target);
  if (argument.required) option->required();
  if (argument.list) option->delimiter(',');
  if (is_repeatable(argument) && !is_positional(argument))
    option->allow_extra_args(argument.greedy);
  if (!argument.when_alone.empty()) {
    option->expected(0, 1)->default_str(std::string(argument.when_alone));
  }
  if (!argument.checked) return;
  if (!argument.choices.empty()) option->check(member_of(argument));
  if (argument.range) option->check(within(argument, *argument.range));
}

/// Sets which arguments need or exclude others, once all have been added.
void relate(CLI::App& app, const Argument& argument) {
  if (argument.needs.empty() && argument.excludes.empty()) return;
  CLI::Option* option = app.get_option(names_of(argument).front());
  if (!argument.needs.empty()) option->needs(app.get_option(std::string(argument.needs)));
  for (const std::string& other : argument.excludes) option->excludes(app.get_option(other));
}

void describe(CLI::App& program, const Subcommand& command) {
  CLI::App* app = program.add_subcommand(std::string(command.name));
  for (const Argument& argument : command.arguments) add(*app, argument);
  for (const Argument& argument : command.arguments) relate(*app, argument);
}

const Subcommand* chosen(const CLI::App& program, std::span<const Subcommand> commands) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  if (named.empty()) return nullptr;
  return &*std::ranges::find(commands, named.back()->get_name(), &Subcommand::name);
}

}  // namespace

Parsed parse(std::span<const Subcommand> commands, std::vector<std::string> arguments) {
  CLI::App program;
  program.name("lumaknot");
  program.set_version_flag("--version");
  program.require_subcommand(0, 1);  // the caller rejects none, CLI11 an unknown one
  for (const Subcommand& command : commands) describe(program, command);
  std::ranges::reverse(arguments);  // the order CLI11 expects
  using Request = Parsed::Request;
  try {
    program.parse(std::move(arguments));
    return {Request::kRun, chosen(program, commands)};
  } catch (const CLI::CallForHelp&) {
    return {Request::kHelp, chosen(program, commands)};
  } catch (const CLI::CallForVersion&) {
    return {Request::kVersion, nullptr};
  } catch (const CLI::ParseError& e) {
    throw Error(fmt::format("{}; try lumaknot --help", e.what()));
  }
}

}  // namespace lumaknot::cli
