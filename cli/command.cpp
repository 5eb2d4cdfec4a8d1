#include "cli/command.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "cli/describe/layout.h"
#include "system/overloaded.h"

namespace lumaknot::cli {
namespace {

std::string numbers(const std::vector<int>& values) {
  std::vector<std::string> words;
  words.reserve(values.size());
  for (const int value : values) words.push_back(std::to_string(value));
  return joined(words, ",");
}

template <class T>
bool holds(const Argument& argument) {
  return std::holds_alternative<T>(argument.target);
}

bool is_whole(const Argument& a) {
  return holds<int*>(a) || holds<std::vector<int>*>(a) || holds<Take<int>>(a) ||
         holds<Take<long long>>(a);
}

bool is_number(const Argument& a) {
  return holds<double*>(a) || holds<std::optional<double>*>(a) || holds<Take<double>>(a);
}

}  // namespace

void append(std::vector<Argument>& arguments, std::vector<Argument> more) {
  arguments.insert(arguments.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
}

bool is_positional(const Argument& argument) { return !argument.names.starts_with('-'); }

bool takes_value(const Argument& argument) { return !holds<bool*>(argument); }

bool is_repeatable(const Argument& argument) {
  return holds<std::vector<int>*>(argument) || holds<std::vector<std::string>*>(argument);
}

std::vector<std::string> names_of(const Argument& argument) {
  std::vector<std::string> names{""};
  for (const char c : argument.names) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

std::string placeholder(const Argument& argument) {
  if (!argument.value.empty()) return std::string(argument.value);
  const std::string one = is_whole(argument) ? "N" : is_number(argument) ? "X" : "NAME";
  return argument.list ? one + ",..." : one;
}

std::string default_of(const Argument& argument) {
  if (!argument.default_text.empty()) return argument.default_text;
  return std::visit(
      Overloaded{[](int* value) { return std::to_string(*value); },
                 [](double* value) { return fmt::format("{}", *value); },
                 [](std::string* value) { return *value; },
                 [](std::vector<int>* values) { return numbers(*values); },
                 [](std::vector<std::string>* values) { return joined(*values, ","); },
                 [](const auto&) { return std::string(); }},
      argument.target);
}

Completion completion_of(const Argument& argument) {
  if (argument.value == kFile) return Completion::kFiles;
  if (argument.value == kFolder) return Completion::kFolders;
  if (argument.value == kProgram) return Completion::kPrograms;
  if (argument.value == kScene) return Completion::kScenes;
  if (argument.choices.empty()) return Completion::kNone;
  return argument.list ? Completion::kList : Completion::kWords;
}

}  // namespace lumaknot::cli
