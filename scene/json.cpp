#include "scene/json.h"

#include <nlohmann/json.hpp>

#include "scene/fields.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

/// Writes a struct's fields into a JSON object.
struct Writer {
  Json json = Json::object();

  Json& put(std::string_view key) { return json[std::string(key)]; }
  void integer(std::string_view key, int value, Interval<int>, std::string_view) {
    put(key) = value;
  }
  void number(std::string_view key, double value, Interval<double>, std::string_view) {
    put(key) = value;
  }
  void vector(std::string_view key, const Vec3d& value, std::string_view) {
    put(key) = components(value);
  }
  void color(std::string_view key, const Vec3d& value, std::string_view about) {
    vector(key, value, about);
  }
  void text(std::string_view key, const std::string& value, std::string_view) { put(key) = value; }
  void constant(std::string_view key, std::string_view value, std::string_view) {
    put(key) = value;
  }
  template <class Enum, std::size_t N>
  void choice(std::string_view key, Enum value, const std::array<std::string_view, N>& names,
              std::string_view) {
    put(key) = names[std::size_t(value)];
  }
  template <class T>
  void object(std::string_view key, T& value, std::string_view) {
    Writer inner;
    visit_fields(inner, value);
    put(key) = inner.json;
  }
  template <class... Ts>
  void one_of(std::string_view key, std::variant<Ts...>& value, std::string_view) {
    Writer inner;
    std::visit([&](auto& held) { visit_value(inner, held); }, value);
    put(key) = inner.json;
  }
  template <class T>
  void list(std::string_view key, std::vector<T>& values, std::size_t, std::string_view about) {
    Json elements = Json::array();
    for (T& value : values) {
      Writer inner;
      inner.one_of("element", value, about);
      elements.push_back(inner.json["element"]);
    }
    put(key) = elements;
  }
};

/// Writes the JSON Schema of a struct's fields.
struct SchemaWriter {
  Json properties = Json::object();

  Json closed_object() const {
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  }
  void put(std::string_view key, std::string_view about, Json schema) {
    schema["description"] = about;
    properties[std::string(key)] = std::move(schema);
  }
  void integer(std::string_view key, int value, Interval<int> range, std::string_view about) {
    put(key, about,
        {{"type", "integer"}, {"minimum", range.min}, {"maximum", range.max}, {"default", value}});
  }
  void number(std::string_view key, double value, Interval<double> range, std::string_view about) {
    Json schema{{"type", "number"}, {"default", value}};
    if (range.min > Interval<double>{}.min)
      schema[range.open_min ? "exclusiveMinimum" : "minimum"] = range.min;
    if (range.max < Interval<double>{}.max)
      schema[range.open_max ? "exclusiveMaximum" : "maximum"] = range.max;
    put(key, about, schema);
  }
  void vector(std::string_view key, const Vec3d& value, std::string_view about) {
    triple(key, value, {{"type", "number"}}, about);
  }
  void color(std::string_view key, const Vec3d& value, std::string_view about) {
    triple(key, value, {{"type", "number"}, {"minimum", 0}, {"maximum", 1}}, about);
  }
  void triple(std::string_view key, const Vec3d& value, Json item, std::string_view about) {
    put(key, about,
        {{"type", "array"},
         {"items", std::move(item)},
         {"minItems", 3},
         {"maxItems", 3},
         {"default", components(value)}});
  }
  void text(std::string_view key, const std::string&, std::string_view about) {
    put(key, about, {{"type", "string"}, {"minLength", 1}});
  }
  void constant(std::string_view key, std::string_view value, std::string_view about) {
    put(key, about, {{"const", value}});
  }
  template <class Enum, std::size_t N>
  void choice(std::string_view key, Enum value, const std::array<std::string_view, N>& names,
              std::string_view about) {
    put(key, about, {{"enum", names}, {"default", names[std::size_t(value)]}});
  }
  template <class T>
  void object(std::string_view key, T& value, std::string_view about) {
    SchemaWriter inner;
    visit_fields(inner, value);
    put(key, about, inner.closed_object());
  }
  template <class... Ts>
  void one_of(std::string_view key, std::variant<Ts...>&, std::string_view about) {
    put(key, about, {{"oneOf", alternatives<Ts...>()}});
  }
  template <class... Ts>
  void list(std::string_view key, std::vector<std::variant<Ts...>>&, std::size_t max,
            std::string_view about) {
    put(key, about,
        {{"type", "array"}, {"maxItems", max}, {"items", {{"oneOf", alternatives<Ts...>()}}}});
  }
  template <class... Ts>
  static Json alternatives() {
    Json choices = Json::array();
    (choices.push_back(alternative<Ts>()), ...);
    return choices;
  }
  template <class T>
  static Json alternative() {
    SchemaWriter inner;
    T value;
    visit_value(inner, value);
    Json schema = inner.closed_object();
    schema["minProperties"] = 1;
    return schema;
  }
};

}  // namespace

std::string scene_to_json(const SceneSpec& spec) {
  Writer writer;
  SceneSpec copy = spec;
  visit_fields(writer, copy);
  return writer.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string scene_json_schema() {
  SchemaWriter writer;
  SceneSpec defaults;
  visit_fields(writer, defaults);
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "lumaknot scene"}};
  schema.update(writer.closed_object());
  return schema.dump(2) + "\n";
}

}  // namespace lumaknot
