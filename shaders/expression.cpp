#include "shaders/expression.h"

#include <unordered_set>

namespace lumaknot {
namespace {

NodePtr make_node(Op op, bool is_vector, std::vector<NodePtr> arguments) {
  return std::make_shared<Node>(Node{op, is_vector, std::move(arguments), {}, {}});
}

Scalar scalar(Op op, std::vector<NodePtr> arguments) {
  return Scalar(make_node(op, false, std::move(arguments)));
}

ScalarVec vector(Op op, std::vector<NodePtr> arguments) {
  return {make_node(op, true, std::move(arguments))};
}

bool is_constant(const Scalar& s) { return s.node->op == Op::kConstant; }

ScalarVec constant_vector(double x) {
  return {std::make_shared<Node>(Node{Op::kConstant, true, {}, {x, x, x}, {}})};
}

NodePtr renamed(const char* name, const NodePtr& node) {
  Node copy = *node;
  if (copy.name.empty()) copy.name = name;
  return std::make_shared<Node>(std::move(copy));
}

void visit(const NodePtr& node, std::unordered_set<const Node*>& seen,
           std::vector<const Node*>& order) {
  if (!seen.insert(node.get()).second) return;
  for (const NodePtr& argument : node->arguments) visit(argument, seen, order);
  order.push_back(node.get());
}

}  // namespace

Scalar::Scalar(double constant)
    : node(std::make_shared<Node>(Node{Op::kConstant, false, {}, {constant, 0, 0}, {}})) {}

ScalarVec vector_input(std::string name) {
  return {std::make_shared<Node>(Node{Op::kInput, true, {}, {}, std::move(name)})};
}

Scalar scalar_parameter(std::string name, double value) {
  return Scalar(
      std::make_shared<Node>(Node{Op::kParameter, false, {}, {value, 0, 0}, std::move(name)}));
}

ScalarVec vector_parameter(std::string name, const Vec3d& value) {
  return {std::make_shared<Node>(Node{Op::kParameter, true, {}, value, std::move(name)})};
}

Scalar operator+(const Scalar& a, const Scalar& b) { return scalar(Op::kAdd, {a.node, b.node}); }
Scalar operator-(const Scalar& a, const Scalar& b) {
  return scalar(Op::kSubtract, {a.node, b.node});
}
Scalar operator*(const Scalar& a, const Scalar& b) {
  return scalar(Op::kMultiply, {a.node, b.node});
}
ScalarVec operator+(const ScalarVec& a, const ScalarVec& b) {
  return vector(Op::kAdd, {a.node, b.node});
}
ScalarVec operator-(const ScalarVec& a, const ScalarVec& b) {
  return vector(Op::kSubtract, {a.node, b.node});
}
ScalarVec operator*(const ScalarVec& v, const Scalar& s) {
  return vector(Op::kScale, {v.node, s.node});
}

Scalar max(const Scalar& a, const Scalar& b) { return scalar(Op::kMaximum, {a.node, b.node}); }

Scalar saturate(const Scalar& x) {
  return scalar(Op::kMinimum, {max(x, Scalar(0)).node, Scalar(1).node});
}

ScalarVec saturate(const ScalarVec& v) {
  const ScalarVec raised = vector(Op::kMaximum, {v.node, constant_vector(0).node});
  return vector(Op::kMinimum, {raised.node, constant_vector(1).node});
}

Scalar power(const Scalar& base, const Scalar& exponent) {
  return scalar(Op::kPower, {base.node, exponent.node});
}

Scalar dot(const ScalarVec& a, const ScalarVec& b) { return scalar(Op::kDot, {a.node, b.node}); }

ScalarVec unit(const ScalarVec& v) { return vector(Op::kUnit, {v.node}); }

ScalarVec make_vec(const Scalar& x, const Scalar& y, const Scalar& z) {
  if (is_constant(x) && is_constant(y) && is_constant(z)) {
    const Vec3d value{x.node->value.x, y.node->value.x, z.node->value.x};
    return {std::make_shared<Node>(Node{Op::kConstant, true, {}, value, {}})};
  }
  return vector(Op::kCombine, {x.node, y.node, z.node});
}

Scalar named(const char* name, const Scalar& x) { return Scalar(renamed(name, x.node)); }
ScalarVec named(const char* name, const ScalarVec& v) { return {renamed(name, v.node)}; }

std::vector<const Node*> in_order(const NodePtr& root) {
  std::unordered_set<const Node*> seen;
  std::vector<const Node*> order;
  visit(root, seen, order);
  return order;
}

}  // namespace lumaknot
