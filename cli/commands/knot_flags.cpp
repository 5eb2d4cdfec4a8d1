#include "cli/commands/knot_flags.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scene/check.h"
#include "scene/fields.h"

namespace lumaknot::cli {
namespace {

/// Builds a flag for every field of a knot.
struct FlagVisitor {
  std::shared_ptr<nlohmann::ordered_json> given;
  std::vector<Argument> flags = {};

  template <class T>
  Argument& add(std::string_view key, std::string_view value, std::string_view about) {
    const auto keep = [given = given, key = std::string(key)](const T& v) { (*given)[key] = v; };
    flags.push_back({.names = field_label("--", key),
                     .target = Take<T>(keep),
                     .meaning = std::string(about),
                     .default_text = std::string(value),
                     .checked = false,
                     .heading = "Knot"});
    return flags.back();
  }
  void integer(std::string_view key, int value, Interval<int> range, std::string_view about) {
    add<long long>(key, std::to_string(value), about).range =
        Interval<double>{double(range.min), double(range.max)};
  }
  void number(std::string_view key, double value, Interval<double> range, std::string_view about) {
    add<double>(key, fmt::format("{}", value), about).range = range;
  }
  template <class Enum, class Names>
  void choice(std::string_view key, Enum value, const Names& names, std::string_view about) {
    add<std::string>(key, std::string(names[std::size_t(value)]), about)
        .choices.assign(names.begin(), names.end());
  }
};

}  // namespace

std::vector<Argument> knot_arguments(std::shared_ptr<nlohmann::ordered_json> given) {
  FlagVisitor visitor{std::move(given)};
  KnotSpec defaults;
  visit_fields(visitor, defaults);
  return std::move(visitor.flags);
}

}  // namespace lumaknot::cli
