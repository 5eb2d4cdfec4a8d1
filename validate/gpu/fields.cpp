#include "validate/gpu/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumaknot::gpu {
namespace {

/// A value as quoted in an error: short, on one line, ASCII only.
std::string in_short(const Json& value) {
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

}  // namespace

Fields::Fields(const Json& object, std::string path) : object_(object), path_(std::move(path)) {
  if (object.is_object()) return;
  throw Error(fmt::format("{} must be an object, got {}", path_.empty() ? "the job" : path_,
                          in_short(object)));
}

std::string Fields::path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void Fields::fail(std::string_view key, std::string_view wanted) const {
  const auto found = object_.find(key);
  throw Error(fmt::format("{} must be {}, got {}", path(key), wanted,
                          found == object_.end() ? "nothing" : in_short(*found)));
}

const Json& Fields::get(std::string_view key) {
  known_.emplace_back(key);
  static const Json none;
  const auto found = object_.find(key);
  return found == object_.end() ? none : *found;
}

std::string Fields::text(std::string_view key) {
  const Json& value = get(key);
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    fail(key, "a non-empty string");
  return value.get<std::string>();
}

std::string Fields::text_or(std::string_view key, std::string otherwise) {
  return has(key) ? text(key) : otherwise;
}

int Fields::integer(std::string_view key, int min, int max) {
  const Json& value = get(key);
  const double number = value.is_number() ? value.get<double>() : 0.5;
  if (number != std::floor(number) || number < min || number > max) {
    fail(key, fmt::format("an integer from {} to {}", min, max));
  }
  return int(number);
}

int Fields::integer_or(std::string_view key, int min, int max, int otherwise) {
  return has(key) ? integer(key, min, max) : otherwise;
}

std::vector<float> Fields::numbers(std::string_view key) {
  const Json& list = get(key);
  if (!list.is_array()) fail(key, "a list of numbers");
  std::vector<float> values;
  for (const Json& value : list) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::abs(number) <= std::numeric_limits<float>::max())) {
      fail(key, "a list of numbers, each within the range of float");
    }
    values.push_back(float(number));
  }
  return values;
}

Fields Fields::object(std::string_view key) { return {get(key), path(key)}; }

std::vector<Fields> Fields::objects(std::string_view key, bool optional) {
  const Json& list = get(key);
  if (optional && !has(key)) return {};
  if (!list.is_array()) fail(key, "a list of objects");
  std::vector<Fields> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    all.emplace_back(list[i], fmt::format("{}[{}]", path(key), i));
  }
  return all;
}

void Fields::finish() const {
  for (const auto& item : object_.items()) {
    if (std::ranges::find(known_, item.key()) != known_.end()) continue;
    throw Error(fmt::format("{} is unknown; must be one of: {}",
                            path_.empty() ? in_short(item.key()) : path_ + "." + item.key(),
                            fmt::join(known_, ", ")));
  }
}

}  // namespace lumaknot::gpu
