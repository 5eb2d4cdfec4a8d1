#include "cli/knot_flags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "scene/check.h"
#include "scene/fields.h"

namespace lumaknot {
namespace {

/// Makes a flag of every field of the knot.
struct FlagVisitor {
  CLI::App& command;
  std::shared_ptr<nlohmann::ordered_json> given;

  template <class T>
  void add(std::string_view key, const std::string& value, const std::string& about) {
    const auto keep = [given = given, key = std::string(key)](const T& v) { (*given)[key] = v; };
    command.add_option_function<T>(field_label("--", key), keep, about)->default_str(value);
  }
  void integer(std::string_view key, int value, IntRange, std::string_view about) {
    add<long long>(key, std::to_string(value), std::string(about));
  }
  void number(std::string_view key, double value, Bound, std::string_view about) {
    add<double>(key, fmt::format("{}", value), std::string(about));
  }
  template <class Enum, class Names>
  void choice(std::string_view key, Enum value, const Names& names, std::string_view about) {
    add<std::string>(key, std::string(names[std::size_t(value)]),
                     fmt::format("{}: {}", about, fmt::join(names, ", ")));
  }
};

}  // namespace

std::shared_ptr<nlohmann::ordered_json> add_knot_flags(CLI::App& command) {
  FlagVisitor visitor{command,
                      std::make_shared<nlohmann::ordered_json>(nlohmann::ordered_json::object())};
  KnotSpec defaults;
  visit_fields(visitor, defaults);
  return visitor.given;
}

}  // namespace lumaknot
