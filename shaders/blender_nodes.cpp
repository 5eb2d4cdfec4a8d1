#include "shaders/blender_nodes.h"

#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <string_view>
#include <unordered_map>

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

/// The Blender node for an operation on scalars or vectors.
struct NodeType {
  Op op;
  bool is_vector;  ///< of the operation's first argument
  std::string_view type, operation, output;
  std::array<std::string_view, 3> sockets;
};

constexpr NodeType kNodeTypes[] = {
    {Op::kAdd, false, "ShaderNodeMath", "ADD", "Value", {"Value", "Value_001"}},
    {Op::kSubtract, false, "ShaderNodeMath", "SUBTRACT", "Value", {"Value", "Value_001"}},
    {Op::kMultiply, false, "ShaderNodeMath", "MULTIPLY", "Value", {"Value", "Value_001"}},
    {Op::kMaximum, false, "ShaderNodeMath", "MAXIMUM", "Value", {"Value", "Value_001"}},
    {Op::kMinimum, false, "ShaderNodeMath", "MINIMUM", "Value", {"Value", "Value_001"}},
    {Op::kPower, false, "ShaderNodeMath", "POWER", "Value", {"Value", "Value_001"}},
    {Op::kAdd, true, "ShaderNodeVectorMath", "ADD", "Vector", {"Vector", "Vector_001"}},
    {Op::kSubtract, true, "ShaderNodeVectorMath", "SUBTRACT", "Vector", {"Vector", "Vector_001"}},
    {Op::kMaximum, true, "ShaderNodeVectorMath", "MAXIMUM", "Vector", {"Vector", "Vector_001"}},
    {Op::kMinimum, true, "ShaderNodeVectorMath", "MINIMUM", "Vector", {"Vector", "Vector_001"}},
    {Op::kScale, true, "ShaderNodeVectorMath", "SCALE", "Vector", {"Vector", "Scale"}},
    {Op::kDot, true, "ShaderNodeVectorMath", "DOT_PRODUCT", "Value", {"Vector", "Vector_001"}},
    {Op::kUnit, true, "ShaderNodeVectorMath", "NORMALIZE", "Vector", {"Vector"}},
    {Op::kCombine, false, "ShaderNodeCombineXYZ", "", "Vector", {"X", "Y", "Z"}},
};

const NodeType& node_type(const Node& node) {
  const bool is_vector = node.arguments.front()->is_vector;
  for (const NodeType& type : kNodeTypes) {
    if (type.op == node.op && type.is_vector == is_vector) return type;
  }
  assert(!"every operation that the recorder knows is in the table");
  return kNodeTypes[0];
}

Json value_json(const Node& node) {
  return node.is_vector ? Json(components(node.value)) : Json(node.value.x);
}

using Indices = std::unordered_map<const Node*, std::size_t>;

Json operation_json(const Node& node, const Indices& index) {
  const NodeType& type = node_type(node);
  Json sockets = Json::object();
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    const Node* argument = node.arguments[i].get();
    sockets[std::string(type.sockets[i])] = argument->op == Op::kConstant
                                                ? Json{{"const", value_json(*argument)}}
                                                : Json{{"node", index.at(argument)}};
  }
  Json json{{"type", type.type}, {"output", type.output}, {"sockets", sockets}};
  if (!type.operation.empty()) json["operation"] = type.operation;
  if (!node.name.empty()) json["label"] = node.name;
  return json;
}

Json node_json(const Node& node, const Indices& index) {
  if (node.op == Op::kInput) return {{"input", node.name}};
  if (node.op == Op::kParameter) {
    return {{node.is_vector ? "vector" : "value", value_json(node)}, {"label", node.name}};
  }
  return operation_json(node, index);
}

}  // namespace

Json blender_nodes(const NodePtr& root) {
  Json nodes = Json::array();
  Indices index;
  for (const Node* node : in_order(root)) {
    if (node->op == Op::kConstant) continue;  // written into the socket that reads it
    nodes.push_back(node_json(*node, index));
    index[node] = nodes.size() - 1;
  }
  return {{"nodes", nodes}, {"output", nodes.size() - 1}};
}

}  // namespace lumaknot
