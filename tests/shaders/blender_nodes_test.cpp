#include "shaders/blender_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "shaders/lighting.h"
#include "shaders/record.h"
#include "tests/shaders/every_shot.h"
#include "tests/shaders/random_surface.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;
using Sockets = std::map<std::string, Vec3d>;

/// What Blender's manual says a node computes; a scalar is kept in x.
struct BlenderNode {
  std::set<std::string> sockets;
  std::string output;
  Vec3d (*compute)(const Sockets&);
};

const Vec3d& value(const Sockets& s, const char* name) { return s.at(name); }
double a(const Sockets& s) { return value(s, "Value").x; }
double b(const Sockets& s) { return value(s, "Value_001").x; }
Vec3d va(const Sockets& s) { return value(s, "Vector"); }
Vec3d vb(const Sockets& s) { return value(s, "Vector_001"); }

/// Every node that a shot may use, by type and operation.
const std::map<std::string, BlenderNode>& known_nodes() {
  static const std::set<std::string> kTwo{"Value", "Value_001"}, kVectors{"Vector", "Vector_001"};
  static const std::map<std::string, BlenderNode> kNodes{
      {"ShaderNodeMath ADD", {kTwo, "Value", [](const Sockets& s) { return Vec3d{a(s) + b(s)}; }}},
      {"ShaderNodeMath SUBTRACT",
       {kTwo, "Value", [](const Sockets& s) { return Vec3d{a(s) - b(s)}; }}},
      {"ShaderNodeMath MULTIPLY",
       {kTwo, "Value", [](const Sockets& s) { return Vec3d{a(s) * b(s)}; }}},
      {"ShaderNodeMath MAXIMUM",
       {kTwo, "Value", [](const Sockets& s) { return Vec3d{std::fmax(a(s), b(s))}; }}},
      {"ShaderNodeMath MINIMUM",
       {kTwo, "Value", [](const Sockets& s) { return Vec3d{std::fmin(a(s), b(s))}; }}},
      {"ShaderNodeMath POWER",
       {kTwo, "Value", [](const Sockets& s) { return Vec3d{std::pow(a(s), b(s))}; }}},
      {"ShaderNodeVectorMath ADD",
       {kVectors, "Vector", [](const Sockets& s) { return va(s) + vb(s); }}},
      {"ShaderNodeVectorMath SUBTRACT",
       {kVectors, "Vector", [](const Sockets& s) { return va(s) - vb(s); }}},
      {"ShaderNodeVectorMath MAXIMUM",
       {kVectors, "Vector",
        [](const Sockets& s) {
          return Vec3d{std::fmax(va(s).x, vb(s).x), std::fmax(va(s).y, vb(s).y),
                       std::fmax(va(s).z, vb(s).z)};
        }}},
      {"ShaderNodeVectorMath MINIMUM",
       {kVectors, "Vector",
        [](const Sockets& s) {
          return Vec3d{std::fmin(va(s).x, vb(s).x), std::fmin(va(s).y, vb(s).y),
                       std::fmin(va(s).z, vb(s).z)};
        }}},
      {"ShaderNodeVectorMath SCALE",
       {{"Vector", "Scale"},
        "Vector",
        [](const Sockets& s) { return va(s) * value(s, "Scale").x; }}},
      {"ShaderNodeVectorMath DOT_PRODUCT",
       {kVectors, "Value", [](const Sockets& s) { return Vec3d{dot(va(s), vb(s))}; }}},
      {"ShaderNodeVectorMath NORMALIZE",
       {{"Vector"}, "Vector", [](const Sockets& s) { return va(s) / length(va(s)); }}},
      {"ShaderNodeCombineXYZ ",
       {{"X", "Y", "Z"},
        "Vector",
        [](const Sockets& s) {
          return Vec3d{value(s, "X").x, value(s, "Y").x, value(s, "Z").x};
        }}},
  };
  return kNodes;
}

std::string kind(const Json& node) {
  return node.at("type").get<std::string>() + " " + node.value("operation", "");
}

Vec3d number(const Json& json) {
  if (json.is_array()) return {json.at(0), json.at(1), json.at(2)};
  return {json.get<double>(), 0, 0};
}

/// Runs the nodes as blender_scene.py would build them.
Vec3d evaluate(const Json& shader, const SurfacePoint<double>& point) {
  const std::map<std::string, Vec3d> inputs{
      {"position", point.position}, {"normal", point.normal}, {"texture", point.texture}};
  std::vector<Vec3d> done;
  for (const Json& node : shader["nodes"]) {
    if (node.contains("input")) {
      done.push_back(inputs.at(node["input"]));
    } else if (node.contains("type")) {
      Sockets sockets;
      for (const auto& [name, source] : node["sockets"].items()) {
        sockets[name] =
            source.contains("node") ? done.at(source["node"]) : number(source.at("const"));
      }
      done.push_back(known_nodes().at(kind(node)).compute(sockets));
    } else {
      done.push_back(number(node.contains("value") ? node["value"] : node.at("vector")));
    }
  }
  return done.at(shader["output"]);
}

/// Calls `check(name, shader)` for every shot's nodes.
template <class F>
void for_each_shader(F check) {
  for (const Shot& shot : every_shot()) check(shot, blender_nodes(record_shot(View{}, shot)));
}

TEST(BlenderNodes, compute_what_the_double_instance_computes) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    const auto lighting = lighting_of<double>(View{}, shot.material);
    RandomSurface random;
    for (int i = 0; i < 50; ++i) {
      const SurfacePoint<double> point = random.point();
      // The same operations; a vector divided by its length may round once more, times 20.
      ASSERT_LT(length(evaluate(shader, point) - stage_color(point, lighting, shot)), 1e-14)
          << shot.name;
    }
  });
}

TEST(BlenderNodes, every_socket_reads_a_constant_or_an_earlier_node) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (std::size_t i = 0; i < shader["nodes"].size(); ++i) {
      const Json sockets = shader["nodes"][i].value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        ASSERT_EQ(source.size(), 1u) << shot.name;
        if (source.contains("node")) {
          EXPECT_LT(source["node"].get<std::size_t>(), i) << shot.name << " " << name;
        } else {
          EXPECT_TRUE(source.contains("const")) << shot.name << " " << name;
        }
      }
    }
  });
}

TEST(BlenderNodes, use_only_nodes_and_sockets_that_blender_has) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      if (!node.contains("type")) continue;
      ASSERT_TRUE(known_nodes().contains(kind(node))) << shot.name << " " << kind(node);
      const BlenderNode& known = known_nodes().at(kind(node));
      std::set<std::string> sockets;
      for (const auto& [name, source] : node["sockets"].items()) sockets.insert(name);
      EXPECT_EQ(sockets, known.sockets) << shot.name << " " << kind(node);
      EXPECT_EQ(node["output"], known.output) << shot.name << " " << kind(node);
    }
  });
}

TEST(BlenderNodes, output_is_the_last_node_and_every_other_is_read) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    std::set<std::size_t> read{shader["output"].get<std::size_t>()};
    for (const Json& node : shader["nodes"]) {
      const Json sockets = node.value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        if (source.contains("node")) read.insert(source["node"].get<std::size_t>());
      }
    }
    EXPECT_EQ(shader["output"], shader["nodes"].size() - 1) << shot.name;
    EXPECT_EQ(read.size(), shader["nodes"].size()) << shot.name;
  });
}

TEST(BlenderNodes, numbers_without_a_name_are_written_into_sockets) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      if (node.contains("type") || node.contains("input")) continue;
      EXPECT_NE(node.value("label", ""), "") << shot.name;  // a parameter of the scene
    }
  });
}

TEST(BlenderNodes, constants_have_the_shape_of_their_sockets) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    for (const Json& node : shader["nodes"]) {
      const Json sockets = node.value("sockets", Json::object());
      for (const auto& [name, source] : sockets.items()) {
        if (!source.contains("const")) continue;
        EXPECT_EQ(source["const"].is_array(), name.starts_with("Vector")) << shot.name;
      }
    }
  });
}

TEST(BlenderNodes, the_texture_stage_is_one_node) {
  Shot shot;
  shot.stage = Stage::kTexture;
  EXPECT_EQ(blender_nodes(record_shot(View{}, shot)),
            (Json{{"nodes", Json::array({Json{{"input", "texture"}}})}, {"output", 0}}));
}

TEST(BlenderNodes, labels_tell_the_formula_s_names) {
  Shot shot;
  shot.material.space = Space::kYiq;
  std::multiset<std::string> labels;
  const Json shader = blender_nodes(record_shot(View{}, shot));
  for (const Json& node : shader["nodes"]) labels.insert(node.value("label", ""));
  for (const char* name : {"to_eye", "to_light", "n", "n_dot_l", "reflection", "light", "highlight",
                           "y", "i", "q", "lit_luma", "shininess", "ambient"}) {
    EXPECT_EQ(labels.count(name), 1u) << name;
  }
}

TEST(BlenderNodes, are_the_same_bytes_each_time) {
  for_each_shader([](const Shot& shot, const Json& shader) {
    EXPECT_EQ(blender_nodes(record_shot(View{}, shot)).dump(), shader.dump()) << shot.name;
  });
}

}  // namespace
}  // namespace lumaknot
