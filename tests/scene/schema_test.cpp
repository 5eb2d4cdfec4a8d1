#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "scene/json.h"
#include "system/atomic_file.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;

Json schema() { return Json::parse(scene_json_schema()); }

constexpr std::string_view kFirst = "[0]";  // after the key of a list: its first element

/// Calls `visit(path, schema)` for every value that is neither an object nor a list of objects:
/// keys, from the scene down.
template <class F>
void for_each_leaf(const Json& node, const std::vector<std::string>& path, F visit) {
  if (node.contains("oneOf")) {
    for (const Json& choice : node["oneOf"]) for_each_leaf(choice, path, visit);
  } else if (node.contains("items") && node["items"].contains("oneOf")) {
    std::vector<std::string> element = path;
    element.back() += kFirst;
    for_each_leaf(node["items"], element, visit);
  } else if (node.contains("properties")) {
    for (const auto& [key, inner] : node["properties"].items()) {
      std::vector<std::string> longer = path;
      longer.push_back(key);
      for_each_leaf(inner, longer, visit);
    }
  } else {
    visit(path, node);
  }
}

std::string dotted(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& key : path) text += (text.empty() ? "" : ".") + key;
  return text;
}

/// A scene that sets one value and nothing else.
std::string scene_with(const std::vector<std::string>& path, const Json& value) {
  Json scene = value;
  for (auto key = path.rbegin(); key != path.rend(); ++key) {
    const bool list = key->ends_with(kFirst);
    scene = list ? Json{{key->substr(0, key->size() - kFirst.size()), Json::array({scene})}}
                 : Json{{*key, scene}};
  }
  return scene.dump();
}

Json at(const Json& json, const std::vector<std::string>& path) {
  Json found = json;
  for (const std::string& key : path) {
    if (!found.is_object()) return {};
    const bool list = key.ends_with(kFirst);
    const Json inner = found.value(list ? key.substr(0, key.size() - kFirst.size()) : key, Json());
    found = list ? inner.at(0) : inner;
  }
  return found;
}

TEST(SceneSchema, describes_every_field_and_closes_every_object) {
  EXPECT_EQ(schema()["additionalProperties"], false);
  int leaves = 0;
  for_each_leaf(schema(), {}, [&](const auto& path, const Json& leaf) {
    EXPECT_NE(leaf.value("description", ""), "") << dotted(path);
    ++leaves;
  });
  // 9 of the knot, 1 mesh file, 3 textures, 4 of the camera; 6, 3 and 9 of the lights; 2 of the
  // ambient light, 19 of the material, 3 of the image.
  EXPECT_EQ(leaves, 62);
}

TEST(SceneSchema, its_defaults_are_what_an_empty_scene_means) {
  const Json defaults = Json::parse(scene_to_json(scene_from_json("{}", "scene.json")));
  int compared = 0;
  for_each_leaf(schema(), {}, [&](const auto& path, const Json& leaf) {
    const Json value = at(defaults, path);
    if (value.is_null() || !leaf.contains("default")) return;  // an alternative not chosen
    EXPECT_EQ(leaf["default"], value) << dotted(path);
    ++compared;
  });
  // All except the two files, the constant, the colour and the lights other than point.
  EXPECT_EQ(compared, 62 - 4 - 12);
}

TEST(SceneSchema, its_defaults_are_accepted_one_by_one) {
  for_each_leaf(schema(), {}, [&](const auto& path, const Json& leaf) {
    const Json value = leaf.contains("default") ? leaf["default"] : leaf.value("const", Json("f"));
    EXPECT_EQ(error_of([&] { scene_from_json(scene_with(path, value), "s"); }), "") << dotted(path);
  });
}

TEST(SceneSchema, what_it_forbids_the_reader_refuses_by_the_same_path) {
  const auto refused = [](const std::vector<std::string>& path, const Json& value) {
    const std::string text = scene_with(path, value);
    EXPECT_THAT(error_of([&] { scene_from_json(text, "s"); }), testing::HasSubstr(dotted(path)))
        << text;
  };
  for_each_leaf(schema(), {}, [&](const auto& path, const Json& leaf) {
    if (leaf.contains("minimum")) refused(path, leaf["minimum"].template get<double>() - 1);
    if (leaf.contains("maximum")) refused(path, leaf["maximum"].template get<double>() + 1);
    if (leaf.contains("exclusiveMinimum")) refused(path, leaf["exclusiveMinimum"]);
    if (leaf.contains("exclusiveMaximum")) refused(path, leaf["exclusiveMaximum"]);
    if (leaf.contains("enum")) refused(path, "no such name");
    if (leaf.contains("minLength")) refused(path, "");
    if (leaf.value("type", "") == "array") refused(path, Json::array({0, 0}));
    refused(path, nullptr);
  });
}

TEST(SceneSchema, the_published_file_is_up_to_date) {
  // Refresh it with: lumaknot scene --schema > docs/scene.schema.json
  const std::string published =
      read_file(LUMAKNOT_SOURCE_DIR "/docs/scene.schema.json", "the published schema");
  EXPECT_EQ(published, scene_json_schema());
}

}  // namespace
}  // namespace lumaknot
