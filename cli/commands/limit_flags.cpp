#include "cli/commands/limit_flags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/commands/shares.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "validate/renderers/entry.h"

namespace lumaknot::cli {
namespace {

using LimitsJson = nlohmann::json;
using validate::Limits;

struct LimitKey {
  std::string_view name;
  std::optional<double> Limits::* value;
};
constexpr std::array kLimitKeys{LimitKey{"max", &Limits::max}, LimitKey{"p99.9", &Limits::p999},
                                LimitKey{"mean", &Limits::mean}};

std::vector<std::string> limit_key_names() {
  std::vector<std::string> names;
  for (const LimitKey& key : kLimitKeys) names.emplace_back(key.name);
  return names;
}

/// Sets one limit; `where` names it in errors.
void set_limit(Limits& limits, std::string_view name, std::optional<double> value,
               const std::string& where) {
  const auto key = std::ranges::find(kLimitKeys, name, &LimitKey::name);
  if (key == kLimitKeys.end()) {
    throw Error(fmt::format("{} is not a known limit; known: {}", where,
                            fmt::join(limit_key_names(), ", ")));
  }
  if (!value || !(*value >= 0 && *value <= 1)) {
    throw Error(fmt::format("{} must be a number from 0 to 1; try 0.005", where));
  }
  limits.*(key->value) = value;
}

Limits limits_of_values(const std::vector<std::string>& values) {
  Limits limits;
  for (const std::string& value : values) {
    const std::size_t equals = std::min(value.find('='), value.size());
    const std::string number = value.substr(std::min(equals + 1, value.size()));
    set_limit(limits, std::string_view(value).substr(0, equals), number_of(number),
              "--limit " + value);
  }
  return limits;
}

LimitsJson parsed_limits(const std::string& file) {
  LimitsJson limits = LimitsJson::parse(read_file(file, "--limits"), nullptr, false);
  if (limits.is_object()) return limits;
  throw Error(fmt::format(
      R"(--limits {} must hold a JSON object such as {{"gl": {{"max": 0.005}}}})", file));
}

bool is_renderer(std::string_view flag) {
  return std::ranges::any_of(validate::renderer_entries(),
                             [&](const auto* entry) { return entry->flag == flag; });
}

std::vector<std::string_view> flags_of_renderers() {
  std::vector<std::string_view> flags;
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    flags.push_back(entry->flag);
  }
  return flags;
}

/// Sets the limits that the file has for one renderer.
void read_limits(const LimitsJson& given, const std::string& where, Limits& limits) {
  if (!given.is_object()) throw Error(where + " must be an object such as {\"max\": 0.005}");
  for (const auto& [name, value] : given.items()) {
    set_limit(limits, name, value.is_number() ? std::optional(value.get<double>()) : std::nullopt,
              where + "." + name);
  }
}

}  // namespace

std::vector<Argument> limit_arguments(LimitFlags& flags) {
  return {{.names = "--limit",
           .target = &flags.values,
           .meaning = "errors to accept in every renderer, in place of the derived limits",
           .value = "KEY=X,...",
           .choices = limit_key_names(),
           .checked = false,
           .list = true},
          {.names = "--limits",
           .target = &flags.file,
           .meaning = "file of such limits by renderer: {\"gl\": {\"max\": 0.005}}",
           .value = kFile}};
}

std::map<std::string, Limits, std::less<>> limits_of(const LimitFlags& flags) {
  std::map<std::string, Limits, std::less<>> all;
  const Limits common = limits_of_values(flags.values);
  for (const std::string_view flag : flags_of_renderers()) all[std::string(flag)] = common;
  if (flags.file.empty()) return all;
  const LimitsJson file = parsed_limits(flags.file);
  for (const auto& [flag, given] : file.items()) {
    const std::string where = fmt::format("--limits {}: {}", flags.file, flag);
    if (!is_renderer(flag)) {
      throw Error(fmt::format("{} is not a known renderer; known: {}", where,
                              fmt::join(flags_of_renderers(), ", ")));
    }
    read_limits(given, where, all[flag]);
  }
  return all;
}

}  // namespace lumaknot::cli
