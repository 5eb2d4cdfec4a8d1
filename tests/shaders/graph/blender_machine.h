/// Runs Blender shader nodes as specified in its manual, in double.
#pragma once

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/shaders/graph/evaluate.h"

namespace lumaknot {

using BlenderJson = nlohmann::ordered_json;
using Sockets = std::map<std::string, Vec3d>;

/// A node's result from its sockets; a scalar is kept in x.
struct BlenderNode {
  std::set<std::string> sockets;
  std::string output;
  Vec3d (*compute)(const Sockets&);
};

namespace blender_machine {

inline double a(const Sockets& s) { return s.at("Value").x; }
inline double b(const Sockets& s) { return s.at("Value_001").x; }
inline Vec3d va(const Sockets& s) { return s.at("Vector"); }
inline Vec3d vb(const Sockets& s) { return s.at("Vector_001"); }
inline Vec3d number(double x) { return {x, 0, 0}; }

template <class F>
Vec3d each(const Sockets& s, F f) {
  return {f(va(s).x, vb(s).x), f(va(s).y, vb(s).y), f(va(s).z, vb(s).z)};
}

/// In Blender a division by zero gives zero.
inline double quotient(double x, double y) { return y != 0 ? x / y : 0; }

/// safe_normalize: zero stays zero.
inline Vec3d normalized(const Vec3d& v) { return length(v) > 0 ? v / length(v) : v; }

using Nodes = std::map<std::string, BlenderNode>;

inline Nodes math_nodes() {
  const std::set<std::string> one{"Value"}, two{"Value", "Value_001"};
  const auto node = [](const auto& sockets, Vec3d (*f)(const Sockets&)) {
    return BlenderNode{sockets, "Value", f};
  };
  return {{"ADD", node(two, [](const Sockets& s) { return number(a(s) + b(s)); })},
          {"SUBTRACT", node(two, [](const Sockets& s) { return number(a(s) - b(s)); })},
          {"MULTIPLY", node(two, [](const Sockets& s) { return number(a(s) * b(s)); })},
          {"DIVIDE", node(two, [](const Sockets& s) { return number(quotient(a(s), b(s))); })},
          {"MAXIMUM", node(two, [](const Sockets& s) { return number(std::fmax(a(s), b(s))); })},
          {"MINIMUM", node(two, [](const Sockets& s) { return number(std::fmin(a(s), b(s))); })},
          {"POWER", node(two, [](const Sockets& s) { return number(std::pow(a(s), b(s))); })},
          {"LOGARITHM",
           node(two, [](const Sockets& s) { return number(std::log(a(s)) / std::log(b(s))); })},
          {"LESS_THAN", node(two, [](const Sockets& s) { return number(a(s) < b(s)); })},
          {"EXPONENT", node(one, [](const Sockets& s) { return number(std::exp(a(s))); })},
          {"SQRT", node(one, [](const Sockets& s) { return number(std::sqrt(a(s))); })},
          {"ABSOLUTE", node(one, [](const Sockets& s) { return number(std::fabs(a(s))); })}};
}

inline Nodes vector_nodes() {
  const std::set<std::string> one{"Vector"}, two{"Vector", "Vector_001"};
  const auto node = [](const auto& sockets, Vec3d (*f)(const Sockets&)) {
    return BlenderNode{sockets, "Vector", f};
  };
  return {
      {"ADD", node(two, [](const Sockets& s) { return va(s) + vb(s); })},
      {"SUBTRACT", node(two, [](const Sockets& s) { return va(s) - vb(s); })},
      {"MULTIPLY",
       node(two,
            [](const Sockets& s) { return each(s, [](double x, double y) { return x * y; }); })},
      {"MAXIMUM", node(two,
                       [](const Sockets& s) {
                         return each(s, [](double x, double y) { return std::fmax(x, y); });
                       })},
      {"MINIMUM", node(two,
                       [](const Sockets& s) {
                         return each(s, [](double x, double y) { return std::fmin(x, y); });
                       })},
      {"CROSS_PRODUCT", node(two, [](const Sockets& s) { return cross(va(s), vb(s)); })},
      {"DOT_PRODUCT", {two, "Value", [](const Sockets& s) { return number(dot(va(s), vb(s))); }}},
      {"SCALE",
       {{"Vector", "Scale"}, "Vector", [](const Sockets& s) { return va(s) * s.at("Scale").x; }}},
      {"NORMALIZE", node(one, [](const Sockets& s) { return normalized(va(s)); })}};
}

inline Nodes all_nodes() {
  Nodes nodes;
  for (const auto& [name, node] : math_nodes()) nodes["ShaderNodeMath " + name] = node;
  for (const auto& [name, node] : vector_nodes()) nodes["ShaderNodeVectorMath " + name] = node;
  nodes["ShaderNodeCombineXYZ "] = {{"X", "Y", "Z"}, "Vector", [](const Sockets& s) {
                                      return Vec3d{s.at("X").x, s.at("Y").x, s.at("Z").x};
                                    }};
  return nodes;
}

}  // namespace blender_machine

/// Every node that a shot may use, by type and operation, except SeparateXYZ with its three
/// outputs.
inline const std::map<std::string, BlenderNode>& known_blender_nodes() {
  static const std::map<std::string, BlenderNode> nodes = blender_machine::all_nodes();
  return nodes;
}

inline std::string blender_kind(const BlenderJson& node) {
  return node.at("type").get<std::string>() + " " + node.value("operation", "");
}

namespace blender_machine {

inline Vec3d number_of(const BlenderJson& json) {
  if (json.is_array()) return {json.at(0), json.at(1), json.at(2)};
  return number(json.get<double>());
}

inline Vec3d run(const BlenderJson& node, const Sockets& sockets) {
  if (node.at("type") == "ShaderNodeSeparateXYZ") {
    const std::string output = node.at("output");
    const Vec3d v = va(sockets);
    return number(output == "X" ? v.x : output == "Y" ? v.y : v.z);
  }
  return known_blender_nodes().at(blender_kind(node)).compute(sockets);
}

}  // namespace blender_machine

/// The colour that `shader`, as blender_nodes() writes it, gives a surface.
inline Vec3d run_blender_nodes(const BlenderJson& shader, const Inputs& inputs) {
  std::vector<Vec3d> done;
  for (const BlenderJson& node : shader["nodes"]) {
    if (node.contains("input")) {
      done.push_back(inputs.at(node["input"]));
    } else if (node.contains("type")) {
      Sockets sockets;
      for (const auto& [name, source] : node["sockets"].items()) {
        sockets[name] = source.contains("node") ? done.at(source["node"])
                                                : blender_machine::number_of(source.at("const"));
      }
      done.push_back(blender_machine::run(node, sockets));
    } else {
      done.push_back(
          blender_machine::number_of(node.contains("value") ? node["value"] : node.at("vector")));
    }
  }
  return done.at(shader["output"]);
}

}  // namespace lumaknot
