#include "shaders/graph/expression.h"

#include <limits>
#include <stdexcept>
#include <unordered_set>

namespace lumaknot {
namespace {

/// The operation's smallest possible value, as far as known from its arguments.
double min_of(const Node& node) {
  constexpr double kUnknown = -std::numeric_limits<double>::infinity();
  const auto min = [&](std::size_t i) { return node.arguments[i]->min; };
  if (node.is_vector) return kUnknown;
  switch (node.op) {
    case Op::kAdd:
      return min(0) + min(1);
    case Op::kMultiply:
      if (node.arguments[0] == node.arguments[1]) return 0;
      return min(0) >= 0 && min(1) >= 0 ? min(0) * min(1) : kUnknown;
    case Op::kDivide:
      return min(0) >= 0 && min(1) >= 0 ? 0 : kUnknown;
    case Op::kMaximum:
      return std::max(min(0), min(1));
    case Op::kMinimum:
      return std::min(min(0), min(1));
    case Op::kSelectLess:
      return std::min(min(2), min(3));
    case Op::kDot:
      return node.arguments[0] == node.arguments[1] ? 0 : kUnknown;
    case Op::kSaturate:
    case Op::kPower:
    case Op::kExp:
    case Op::kSqrt:
    case Op::kAbs:
      return 0;
    default:
      return kUnknown;
  }
}

NodePtr make_node(Op op, bool is_vector, std::vector<NodePtr> arguments) {
  Node node;
  node.op = op;
  node.is_vector = is_vector;
  node.arguments = std::move(arguments);
  node.min = min_of(node);
  return std::make_shared<Node>(std::move(node));
}

NodePtr make_leaf(Op op, bool is_vector, const Vec3d& value, std::string name) {
  Node node;
  node.op = op;
  node.is_vector = is_vector;
  node.value = value;
  if (op == Op::kConstant && !is_vector) node.min = value.x;
  node.name = std::move(name);
  return std::make_shared<Node>(std::move(node));
}

Scalar scalar(Op op, std::vector<NodePtr> arguments) {
  return Scalar(make_node(op, false, std::move(arguments)));
}

ScalarVec vector(Op op, std::vector<NodePtr> arguments) {
  return {make_node(op, true, std::move(arguments))};
}

ScalarVec constant_vector(const Vec3d& value) {
  return {make_leaf(Op::kConstant, true, value, {})};
}

bool is_constant(const NodePtr& node) { return node->op == Op::kConstant; }
bool is_constant(const Scalar& s, double value) {
  return is_constant(s.node) && s.node->value.x == value;
}
bool is_zero(const ScalarVec& v) { return is_constant(v.node) && v.node->value == Vec3d{}; }

double value_of(const Scalar& s) { return s.node->value.x; }

bool both_constant(const NodePtr& a, const NodePtr& b) { return is_constant(a) && is_constant(b); }

/// Whether all components of `v` are one scalar, which grey_of() then returns.
bool is_grey(const ScalarVec& v) {
  const Vec3d& value = v.node->value;
  return v.node->op == Op::kGrey ||
         (is_constant(v.node) && value.x == value.y && value.y == value.z);
}

Scalar grey_of(const ScalarVec& v) {
  return is_constant(v.node) ? Scalar(v.node->value.x) : Scalar(v.node->arguments[0]);
}

/// A scalar operation component by component; for grey vectors, one on scalars.
template <class F>
ScalarVec componentwise(Op op, const ScalarVec& a, const ScalarVec& b, F on_scalars) {
  if (is_grey(a) && is_grey(b)) return grey(on_scalars(grey_of(a), grey_of(b)));
  return vector(op, {a.node, b.node});
}

Scalar component(Op op, const ScalarVec& v) {
  const std::size_t index = std::size_t(op) - std::size_t(Op::kX);
  if (is_grey(v)) return grey_of(v);
  if (is_constant(v.node)) return Scalar(components(v.node->value)[index]);
  if (v.node->op == Op::kCombine) return Scalar(v.node->arguments[index]);
  return scalar(op, {v.node});
}

NodePtr renamed(const char* name, const NodePtr& node) {
  if (!node->name.empty() || is_constant(node)) return node;
  Node copy = *node;
  copy.name = name;
  return std::make_shared<Node>(std::move(copy));
}

void refuse_unless(bool allowed, const char* what) {
  if (!allowed) throw std::logic_error(std::string("the formula takes ") + what);
}

void visit(const NodePtr& node, std::unordered_set<const Node*>& seen,
           std::vector<const Node*>& order) {
  if (!seen.insert(node.get()).second) return;
  for (const NodePtr& argument : node->arguments) visit(argument, seen, order);
  order.push_back(node.get());
}

}  // namespace

Scalar::Scalar(double constant) : node(make_leaf(Op::kConstant, false, {constant, 0, 0}, {})) {}

Scalar scalar_input(std::string name) {
  return Scalar(make_leaf(Op::kInput, false, {}, std::move(name)));
}

ScalarVec vector_input(std::string name) {
  return {make_leaf(Op::kInput, true, {}, std::move(name))};
}

Scalar scalar_parameter(std::string name, double value) {
  return Scalar(make_leaf(Op::kParameter, false, {value, 0, 0}, std::move(name)));
}

ScalarVec vector_parameter(std::string name, const Vec3d& value) {
  return {make_leaf(Op::kParameter, true, value, std::move(name))};
}

Scalar operator+(const Scalar& a, const Scalar& b) {
  if (both_constant(a.node, b.node)) return value_of(a) + value_of(b);
  if (is_constant(a, 0)) return b;
  if (is_constant(b, 0)) return a;
  return scalar(Op::kAdd, {a.node, b.node});
}

Scalar operator-(const Scalar& a, const Scalar& b) {
  if (both_constant(a.node, b.node)) return value_of(a) - value_of(b);
  if (is_constant(b, 0)) return a;
  return scalar(Op::kSubtract, {a.node, b.node});
}

Scalar operator*(const Scalar& a, const Scalar& b) {
  if (both_constant(a.node, b.node)) return value_of(a) * value_of(b);
  if (is_constant(a, 0) || is_constant(b, 1)) return a;
  if (is_constant(b, 0) || is_constant(a, 1)) return b;
  return scalar(Op::kMultiply, {a.node, b.node});
}

Scalar operator/(const Scalar& a, const Scalar& b) {
  refuse_unless(!is_constant(b, 0), "a quotient by zero");
  if (both_constant(a.node, b.node)) return value_of(a) / value_of(b);
  if (is_constant(a, 0) || is_constant(b, 1)) return a;
  return scalar(Op::kDivide, {a.node, b.node});
}

ScalarVec operator+(const ScalarVec& a, const ScalarVec& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return componentwise(Op::kAdd, a, b, [](const Scalar& x, const Scalar& y) { return x + y; });
}

ScalarVec operator-(const ScalarVec& a, const ScalarVec& b) {
  if (is_zero(b)) return a;
  return componentwise(Op::kSubtract, a, b, [](const Scalar& x, const Scalar& y) { return x - y; });
}

ScalarVec operator*(const ScalarVec& v, const Scalar& s) {
  if (is_grey(v)) return grey(grey_of(v) * s);
  if (is_constant(s, 1)) return v;
  if (is_constant(s, 0)) return constant_vector({});
  return vector(Op::kScale, {v.node, s.node});
}

Scalar max(const Scalar& a, const Scalar& b) {
  if (both_constant(a.node, b.node)) return std::max(value_of(a), value_of(b));
  if (is_constant(b.node) && a.node->min >= value_of(b)) return a;
  return scalar(Op::kMaximum, {a.node, b.node});
}

Scalar min(const Scalar& a, const Scalar& b) {
  if (both_constant(a.node, b.node)) return std::min(value_of(a), value_of(b));
  return scalar(Op::kMinimum, {a.node, b.node});
}

Scalar abs(const Scalar& x) {
  if (is_constant(x.node)) return std::abs(value_of(x));
  return scalar(Op::kAbs, {x.node});
}

Scalar sqrt(const Scalar& x) {
  refuse_unless(x.node->min >= 0, "the root of a number that may be negative");
  return scalar(Op::kSqrt, {x.node});
}

Scalar exp(const Scalar& x) { return scalar(Op::kExp, {x.node}); }

Scalar log(const Scalar& x) {
  refuse_unless(x.node->min > 0, "the logarithm of a number that may be zero");
  return scalar(Op::kLog, {x.node});
}

Scalar power(const Scalar& base, const Scalar& exponent) {
  refuse_unless(base.node->min >= 0, "the power of a number that may be negative");
  if (is_constant(exponent, 1)) return base;
  if (is_constant(exponent, 0)) return 1;  // of 0 too
  return scalar(Op::kPower, {base.node, exponent.node});
}

Scalar select_less(const Scalar& a, const Scalar& b, const Scalar& x, const Scalar& y) {
  if (both_constant(a.node, b.node)) return value_of(a) < value_of(b) ? x : y;
  if (both_constant(x.node, y.node) && value_of(x) == value_of(y)) return x;
  return scalar(Op::kSelectLess, {a.node, b.node, x.node, y.node});
}

Scalar saturate(const Scalar& x) {
  if (is_constant(x.node)) return saturate(value_of(x));
  if (x.node->op == Op::kSaturate) return x;
  const bool is_raised = x.node->op == Op::kMaximum && is_constant(x.node->arguments[1]) &&
                         x.node->arguments[1]->value.x <= 0;
  if (is_raised) return saturate(Scalar(x.node->arguments[0]));
  return scalar(Op::kSaturate, {x.node});
}

ScalarVec saturate(const ScalarVec& v) {
  return is_grey(v) ? grey(saturate(grey_of(v))) : vector(Op::kSaturate, {v.node});
}

ScalarVec modulate(const ScalarVec& a, const ScalarVec& b) {
  if (is_grey(a)) return b * grey_of(a);
  if (is_grey(b)) return a * grey_of(b);
  return vector(Op::kMultiply, {a.node, b.node});
}

Scalar dot(const ScalarVec& a, const ScalarVec& b) {
  if (both_constant(a.node, b.node)) return dot(a.node->value, b.node->value);
  if (is_zero(a) || is_zero(b)) return 0;
  return scalar(Op::kDot, {a.node, b.node});
}

ScalarVec cross(const ScalarVec& a, const ScalarVec& b) {
  return vector(Op::kCross, {a.node, b.node});
}

ScalarVec unit(const ScalarVec& v) { return vector(Op::kUnit, {v.node}); }

ScalarVec make_vec(const Scalar& x, const Scalar& y, const Scalar& z) {
  if (both_constant(x.node, y.node) && is_constant(z.node)) {
    return constant_vector({value_of(x), value_of(y), value_of(z)});
  }
  if (x.node == y.node && y.node == z.node) return grey(x);
  return vector(Op::kCombine, {x.node, y.node, z.node});
}

ScalarVec grey(const Scalar& x) {
  if (is_constant(x.node)) return constant_vector({value_of(x), value_of(x), value_of(x)});
  return vector(Op::kGrey, {x.node});
}

Scalar x_of(const ScalarVec& v) { return component(Op::kX, v); }
Scalar y_of(const ScalarVec& v) { return component(Op::kY, v); }
Scalar z_of(const ScalarVec& v) { return component(Op::kZ, v); }

Scalar named(const char* name, const Scalar& x) { return Scalar(renamed(name, x.node)); }
ScalarVec named(const char* name, const ScalarVec& v) {
  if (is_grey(v)) return grey(named(name, grey_of(v)));
  return {renamed(name, v.node)};
}

std::vector<const Node*> in_order(const std::vector<NodePtr>& roots) {
  std::unordered_set<const Node*> seen;
  std::vector<const Node*> order;
  for (const NodePtr& root : roots) visit(root, seen, order);
  return order;
}

}  // namespace lumaknot
