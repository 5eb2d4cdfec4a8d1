#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "scene/check.h"
#include "scene/fields.h"
#include "scene/json.h"
#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

/// A value as an error message quotes it: short, on one line, ASCII only.
std::string in_short(const Json& value) {
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

/// A key as a path shows it: in quotes unless it is plain text.
std::string shown(std::string_view key) {
  const std::string text = in_short(key);
  const bool plain = text.size() == key.size() + 2;  // nothing was escaped or cut
  return plain ? std::string(key) : text;
}

/// Calls `visit(alternative)` with a default value of each type of the variant.
template <class... Ts, class F>
void for_each_alternative(const std::variant<Ts...>&, F visit) {
  (visit(Ts{}), ...);
}

/// Fills a struct from a JSON object, key by key.
class Reader {
 public:
  Reader(const Json& object, std::string path) : object_(object), path_(std::move(path)) {
    if (!object.is_object()) {
      throw Error(fmt::format("{} must be an object, got {}", path_.empty() ? "the scene" : path_,
                              in_short(object)));
    }
  }

  void integer(std::string_view key, int& value, Interval<int> range, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    // As in JSON Schema, 720.0 is an integer too. Every number here is exact as a double or too
    // large for any range.
    const double number = found->is_number() ? found->get<double>() : 0.5;
    if (number != std::floor(number)) fail(key, "an integer", *found);
    if (number < range.min || number > range.max) {
      fail(key, fmt::format("an integer from {} to {}", range.min, range.max), *found);
    }
    value = int(number);
  }
  void number(std::string_view key, double& value, Interval<double> range, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_number()) fail(key, "a number", *found);
    check_number(label(key), found->get<double>(), range);
    value = found->get<double>();
  }
  void vector(std::string_view key, Vec3d& value, std::string_view) { triple(key, value, {}); }
  void color(std::string_view key, Vec3d& value, std::string_view) {
    triple(key, value, {.min = 0, .max = 1});
  }
  void text(std::string_view key, std::string& value, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
      fail(key, "a file name", *found);
    }
    value = found->get<std::string>();
  }
  void constant(std::string_view key, std::string_view value, std::string_view) {
    const Json* found = find(key);
    if (found && *found != value) fail(key, fmt::format("\"{}\"", value), *found);
  }
  template <class Enum, std::size_t N>
  void choice(std::string_view key, Enum& value, const std::array<std::string_view, N>& names,
              std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    for (std::size_t i = 0; i < N; ++i) {
      if (*found == names[i]) {
        value = Enum(i);
        return;
      }
    }
    fail(key, fmt::format("one of \"{}\"", fmt::join(names, "\", \"")), *found);
  }
  template <class T>
  void object(std::string_view key, T& value, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    Reader inner(*found, label(key));
    visit_fields(inner, value);
    inner.finish();
  }
  void object(std::string_view key, KnotSpec& value, std::string_view) {
    const Json* found = find(key);
    if (found) value = knot(*found, label(key));
  }
  template <class... Ts>
  void one_of(std::string_view key, std::variant<Ts...>& value, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    read_one_of(*found, label(key), value);
  }
  template <class T>
  void list(std::string_view key, std::vector<T>& values, std::size_t max, std::string_view) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_array() || found->size() > max) {
      fail(key, fmt::format("a list of at most {}", max), *found);
    }
    values.assign(found->size(), T{});
    for (std::size_t i = 0; i < values.size(); ++i) {
      read_one_of((*found)[i], fmt::format("{}[{}]", label(key), i), values[i]);
    }
  }

  /// A knot: missing fields are those of its convention.
  static KnotSpec knot(const Json& json, const std::string& path) {
    KnotSpec knot;
    Reader(json, path).choice("convention", knot.convention, kConventionNames, "");
    knot = knot_defaults(knot.convention);
    const double winding_share = knot.minor_radius / knot.major_radius;
    Reader reader(json, path);
    visit_fields(reader, knot);
    reader.finish();
    if (has_fixed_winding(knot.convention) && !json.contains("winding")) {
      knot.minor_radius = winding_share * knot.major_radius;
    }
    return knot;
  }

  /// Refuses the keys that no field has read.
  void finish() const {
    for (const auto& [key, value] : object_.items()) {
      if (std::ranges::find(known_, key) != known_.end()) continue;
      throw Error(fmt::format("{} is not a known key; known here: {}", label(key),
                              fmt::join(known_, ", ")));
    }
  }

 private:
  template <class... Ts>
  static void read_one_of(const Json& json, const std::string& path, std::variant<Ts...>& value) {
    Reader inner(json, path);
    for_each_alternative(value, [&](auto alternative) {
      const std::size_t before = inner.used_;
      visit_value(inner, alternative);
      if (inner.used_ > before) value = alternative;
    });
    inner.finish();
    if (inner.used_ != 1) {
      throw Error(fmt::format("{} must have exactly one of the keys {}, got {}", path,
                              fmt::join(inner.known_, ", "), in_short(json)));
    }
  }
  std::string label(std::string_view key) const {
    if (path_ == "--") return field_label(path_, key);
    return path_.empty() ? shown(key) : fmt::format("{}.{}", path_, shown(key));
  }
  const Json* find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
    const auto found = object_.find(std::string(key));
    if (found == object_.end()) return nullptr;
    ++used_;
    return &*found;
  }
  [[noreturn]] void fail(std::string_view key, std::string_view wanted, const Json& got) const {
    throw Error(fmt::format("{} must be {}, got {}", label(key), wanted, in_short(got)));
  }
  void triple(std::string_view key, Vec3d& value, Interval<double> range) {
    const Json* found = find(key);
    if (!found) return;
    if (!found->is_array() || found->size() != 3) fail(key, "three numbers", *found);
    double parts[3];
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(*found)[i].is_number()) fail(key, "three numbers", *found);
      parts[i] = (*found)[i].get<double>();
      check_number(fmt::format("{}[{}]", label(key), i), parts[i], range);
    }
    value = {parts[0], parts[1], parts[2]};
  }

  const Json& object_;
  std::string path_;
  std::vector<std::string> known_;
  std::size_t used_ = 0;
};

/// The key of the value `in_quotes`, for an error message.
std::string key_before(std::string_view text, std::string_view in_quotes) {
  const std::size_t at = text.find(in_quotes.substr(1, in_quotes.size() - 2));
  const std::size_t end = text.rfind('"', at), begin = text.rfind('"', end - 1);
  if (at == text.npos || end == text.npos || begin == text.npos) return "a value";
  return shown(text.substr(begin + 1, end - begin - 1));
}

/// Deeper than any scene; unlimited nesting must not exhaust the stack.
constexpr int kMaxDepth = 64;

/// The text as JSON. Throws Error naming the place where it is not JSON.
Json parse(std::string_view text, std::string_view source) {
  const auto limit_depth = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kMaxDepth) return true;
    throw Error(
        fmt::format("{} is nested more than {} levels deep, which no scene is", source, kMaxDepth));
  };
  try {
    return Json::parse(text, limit_depth);
  } catch (const Json::out_of_range& e) {  // reads "[...] number overflow parsing '1e999'"
    const std::string why = e.what();
    const std::string number = why.substr(std::min(why.size(), why.find('\'')));
    throw Error(fmt::format("{}: {} is {}, too large for a double; numbers must be finite", source,
                            key_before(text, number), number));
  } catch (const nlohmann::json::exception& e) {
    // Its messages read "[json.exception.parse_error.101] parse error at line 1, column 2: ...".
    std::string why = e.what();
    why = why.substr(std::min(why.size(), why.find("] ") + 2));
    std::ranges::replace(why, '\n', ' ');
    throw Error(fmt::format("{} is not JSON: {}", source, why));
  }
}

}  // namespace

KnotSpec knot_from_json(const Json& json, const std::string& prefix) {
  const KnotSpec knot = Reader::knot(json, prefix);
  check_knot(knot, prefix);
  return knot;
}

SceneSpec scene_from_json(std::string_view text, std::string_view source) {
  const Json json = parse(text, source);
  SceneSpec spec;
  Reader reader(json, "");
  visit_fields(reader, spec);
  reader.finish();
  check_scene(spec);
  return spec;
}

}  // namespace lumaknot
