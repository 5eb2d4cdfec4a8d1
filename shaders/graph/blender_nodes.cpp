#include "shaders/graph/blender_nodes.h"

#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <numbers>
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

constexpr std::array<std::string_view, 3> kValues{"Value", "Value_001"};
constexpr std::array<std::string_view, 3> kVectors{"Vector", "Vector_001"};

constexpr NodeType kNodeTypes[] = {
    {Op::kAdd, false, "ShaderNodeMath", "ADD", "Value", kValues},
    {Op::kSubtract, false, "ShaderNodeMath", "SUBTRACT", "Value", kValues},
    {Op::kMultiply, false, "ShaderNodeMath", "MULTIPLY", "Value", kValues},
    {Op::kDivide, false, "ShaderNodeMath", "DIVIDE", "Value", kValues},
    {Op::kMaximum, false, "ShaderNodeMath", "MAXIMUM", "Value", kValues},
    {Op::kMinimum, false, "ShaderNodeMath", "MINIMUM", "Value", kValues},
    {Op::kPower, false, "ShaderNodeMath", "POWER", "Value", kValues},
    {Op::kExp, false, "ShaderNodeMath", "EXPONENT", "Value", kValues},
    {Op::kSqrt, false, "ShaderNodeMath", "SQRT", "Value", kValues},
    {Op::kAbs, false, "ShaderNodeMath", "ABSOLUTE", "Value", kValues},
    {Op::kAdd, true, "ShaderNodeVectorMath", "ADD", "Vector", kVectors},
    {Op::kSubtract, true, "ShaderNodeVectorMath", "SUBTRACT", "Vector", kVectors},
    {Op::kMultiply, true, "ShaderNodeVectorMath", "MULTIPLY", "Vector", kVectors},
    {Op::kMaximum, true, "ShaderNodeVectorMath", "MAXIMUM", "Vector", kVectors},
    {Op::kMinimum, true, "ShaderNodeVectorMath", "MINIMUM", "Vector", kVectors},
    {Op::kCross, true, "ShaderNodeVectorMath", "CROSS_PRODUCT", "Vector", kVectors},
    {Op::kScale, true, "ShaderNodeVectorMath", "SCALE", "Vector", {"Vector", "Scale"}},
    {Op::kDot, true, "ShaderNodeVectorMath", "DOT_PRODUCT", "Value", kVectors},
    {Op::kUnit, true, "ShaderNodeVectorMath", "NORMALIZE", "Vector", {"Vector"}},
    {Op::kX, true, "ShaderNodeSeparateXYZ", "", "X", {"Vector"}},
    {Op::kY, true, "ShaderNodeSeparateXYZ", "", "Y", {"Vector"}},
    {Op::kZ, true, "ShaderNodeSeparateXYZ", "", "Z", {"Vector"}},
    {Op::kCombine, false, "ShaderNodeCombineXYZ", "", "Vector", {"X", "Y", "Z"}},
};

const NodeType& node_type(const Node& node) {
  const bool is_vector = node.arguments.front()->is_vector;
  for (const NodeType& type : kNodeTypes) {
    if (type.op == node.op && type.is_vector == is_vector) return type;
  }
  assert(false && "every operation that the recorder knows is in the table");
  return kNodeTypes[0];
}

Json value_json(const Node& node) {
  return node.is_vector ? Json(components(node.value)) : Json(node.value.x);
}

/// Writes the nodes of a graph, each after those it reads.
class NodeWriter {
 public:
  explicit NodeWriter(ParameterNodes parameters) : parameters_(parameters) {}

  Json nodes = Json::array();

  void write(const Node& node) {
    if (node.op == Op::kConstant) return;  // written into the socket that reads it
    index_[&node] = written(node);
    if (!node.name.empty() && !nodes.back().contains("input")) nodes.back()["label"] = node.name;
  }

 private:
  std::size_t written(const Node& node) {
    const auto source = [&](std::size_t i) { return this->source(node.arguments[i]); };
    switch (node.op) {
      case Op::kInput:
        return push({{"input", node.name}});
      case Op::kParameter:
        return parameter(node);
      case Op::kGrey:
        return combine(source(0));
      case Op::kSaturate:
        return saturate(source(0), node.is_vector);
      case Op::kLog:
        return math("LOGARITHM", source(0), {{"const", std::numbers::e}});
      case Op::kSelectLess:
        return select(source(0), source(1), source(2), source(3));
      default:
        return operation(node);
    }
  }

  std::size_t parameter(const Node& node) {
    if (parameters_ == ParameterNodes::kInputs) return push({{"input", node.name}});
    return push({{node.is_vector ? "vector" : "value", value_json(node)}});
  }
  std::size_t push(Json json) {
    nodes.push_back(std::move(json));
    return nodes.size() - 1;
  }
  Json source(const NodePtr& node) const {
    return node->op == Op::kConstant ? Json{{"const", value_json(*node)}}
                                     : Json{{"node", index_.at(node.get())}};
  }
  std::size_t math(std::string_view name, const Json& a, const Json& b, bool on_vectors = false) {
    const std::string socket = on_vectors ? "Vector" : "Value";
    return push({{"type", on_vectors ? "ShaderNodeVectorMath" : "ShaderNodeMath"},
                 {"output", socket},
                 {"sockets", {{socket, a}, {socket + "_001", b}}},
                 {"operation", name}});
  }
  std::size_t saturate(const Json& x, bool is_vector) {
    const auto limit = [&](double v) {
      return Json{{"const", is_vector ? Json(std::array{v, v, v}) : Json(v)}};
    };
    const Json raised{{"node", math("MAXIMUM", x, limit(0), is_vector)}};
    return math("MINIMUM", raised, limit(1), is_vector);
  }
  std::size_t combine(const Json& x) {
    return push({{"type", "ShaderNodeCombineXYZ"},
                 {"output", "Vector"},
                 {"sockets", {{"X", x}, {"Y", x}, {"Z", x}}}});
  }
  /// a < b ? x : y as t x + (1 - t) y with t 1 or 0: exact, as both are finite.
  std::size_t select(const Json& a, const Json& b, const Json& x, const Json& y) {
    const auto node = [](std::size_t index) { return Json{{"node", index}}; };
    const Json less = node(math("LESS_THAN", a, b));
    const Json not_less = node(math("SUBTRACT", {{"const", 1.0}}, less));
    const Json chosen_x = node(math("MULTIPLY", less, x));
    return math("ADD", chosen_x, node(math("MULTIPLY", not_less, y)));
  }
  std::size_t operation(const Node& node) {
    const NodeType& type = node_type(node);
    Json sockets = Json::object();
    for (std::size_t i = 0; i < node.arguments.size(); ++i) {
      sockets[std::string(type.sockets[i])] = source(node.arguments[i]);
    }
    Json json{{"type", type.type}, {"output", type.output}, {"sockets", sockets}};
    if (!type.operation.empty()) json["operation"] = type.operation;
    return push(std::move(json));
  }

  ParameterNodes parameters_;
  std::unordered_map<const Node*, std::size_t> index_;
};

}  // namespace

Json blender_nodes(const NodePtr& root, ParameterNodes parameters) {
  NodeWriter writer(parameters);
  for (const Node* node : in_order({root})) writer.write(*node);
  // A formula that is one constant still needs a node to read it from.
  if (writer.nodes.empty()) {
    writer.nodes.push_back({{"vector", components(root->value)}, {"label", "color"}});
  }
  return {{"nodes", writer.nodes}, {"output", writer.nodes.size() - 1}};
}

}  // namespace lumaknot
