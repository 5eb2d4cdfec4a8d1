/// A bound on the error of a recorded formula in single precision, derived instead of measured: the
/// graph's value in double, and by reverse differentiation how each rounding on the way moves the
/// result. The bound adds all of them up with their worst signs. First order: products of roundings
/// (1e-14) are left out, and so is a rounding that changes the side of a select_less.
#pragma once

#include <map>
#include <numbers>
#include <unordered_map>

#include "shaders/graph/expression.h"

namespace lumaknot::rounding {

/// Half the spacing of float relative to its value.
inline constexpr double kFloatRounding = 0x1p-24;

/// Errors of a present-day C library's functions: one last place. Relative, the logarithm's
/// absolute.
struct LibraryErrors {
  static constexpr double kRounding = kFloatRounding;  ///< of a sum, a product, a constant
  static double division() { return kFloatRounding; }
  static double root() { return kFloatRounding; }
  static double exponential(double) { return 2 * kFloatRounding; }
  static double logarithm(double x) { return 2 * kFloatRounding * std::abs(std::log(x)); }
  static double power(double, double) { return 2 * kFloatRounding; }
};

/// Vulkan's requirements for an implementation ("Precision and Operation of SPIR-V Instructions"):
/// division 2.5 last places; sqrt as 1 / inversesqrt (2); exp2 3 + 2 |x|; log2 3, and 2^-21
/// absolute in [0.5, 2]; exp, log and pow by these two.
struct VulkanErrors {
  static constexpr double kRounding = kFloatRounding;
  static constexpr double kUlp = 2 * kFloatRounding;
  static double division() { return 2.5 * kUlp; }
  static double root() { return 4.5 * kUlp; }
  static double exp2(double x) { return (3 + 2 * std::abs(x)) * kUlp; }
  static double log2(double x) {
    return x >= 0.5 && x <= 2 ? 0x1p-21 : 3 * kUlp * std::abs(std::log2(x));
  }
  static double exponential(double x) {
    return exp2(x * std::numbers::log2e) + 2 * kFloatRounding * std::abs(x);
  }
  static double logarithm(double x) {
    return (log2(x) + 2 * kFloatRounding * std::abs(std::log2(x))) * std::numbers::ln2;
  }
  static double power(double base, double exponent) {
    const double argument = exponent * std::log2(base);
    const double off = exponent * log2(base) + kFloatRounding * std::abs(argument);
    return exp2(argument) + off * std::numbers::ln2;
  }
};

/// The values of a formula's inputs and changed parameters by name; scalars in x.
using Inputs = std::map<std::string, Vec3d>;

/// A graph as a list, each node after its arguments.
struct Tape {
  NodePtr root;  ///< keeps the nodes
  std::vector<const Node*> nodes;
  std::vector<std::vector<std::size_t>> arguments;  ///< of each node, as places in `nodes`
};

inline Tape tape_of(const NodePtr& root) {
  Tape tape{root, in_order({root}), {}};
  std::unordered_map<const Node*, std::size_t> place;
  for (const Node* node : tape.nodes) {
    std::vector<std::size_t> arguments;
    for (const NodePtr& argument : node->arguments) arguments.push_back(place.at(argument.get()));
    tape.arguments.push_back(std::move(arguments));
    place.emplace(node, place.size());
  }
  return tape;
}

template <class F>
Vec3d by_component(const Vec3d& a, const Vec3d& b, F f) {
  return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}

inline Vec3d absolute(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// What `node` computes from its arguments' values `a`.
inline Vec3d value_of(const Node& node, const std::vector<Vec3d>& a, const Inputs& inputs) {
  switch (node.op) {
    case Op::kInput:
      return inputs.at(node.name);
    case Op::kParameter:
      return inputs.contains(node.name) ? inputs.at(node.name) : node.value;
    case Op::kConstant:
      return node.value;
    case Op::kAdd:
      return a[0] + a[1];
    case Op::kSubtract:
      return a[0] - a[1];
    case Op::kMultiply:
      return modulate(a[0], a[1]);
    case Op::kMaximum:
      return by_component(a[0], a[1], max<double>);
    case Op::kMinimum:
      return by_component(a[0], a[1], min<double>);
    case Op::kSaturate:
      return saturate(a[0]);
    case Op::kDivide:
      return {a[0].x / a[1].x, 0, 0};
    case Op::kPower:
      return {power(a[0].x, a[1].x), 0, 0};
    case Op::kExp:
      return {exp(a[0].x), 0, 0};
    case Op::kLog:
      return {log(a[0].x), 0, 0};
    case Op::kSqrt:
      return {sqrt(a[0].x), 0, 0};
    case Op::kAbs:
      return {abs(a[0].x), 0, 0};
    case Op::kSelectLess:
      return a[0].x < a[1].x ? a[2] : a[3];
    case Op::kScale:
      return a[0] * a[1].x;
    case Op::kDot:
      return {dot(a[0], a[1]), 0, 0};
    case Op::kCross:
      return cross(a[0], a[1]);
    case Op::kUnit:
      return unit(a[0]);
    case Op::kCombine:
      return {a[0].x, a[1].x, a[2].x};
    case Op::kGrey:
      return grey(a[0].x);
    case Op::kX:
      return {a[0].x, 0, 0};
    case Op::kY:
      return {a[0].y, 0, 0};
    case Op::kZ:
      return {a[0].z, 0, 0};
  }
  return {};
}

/// The rounding of this node alone, absolute; `r` is its value.
template <class Errors>
Vec3d own_error(const Node& node, const std::vector<Vec3d>& a, const Vec3d& r) {
  constexpr bool kIsFloat = Errors::kRounding == kFloatRounding;
  const auto to_float = [](double x, double) {
    return kIsFloat ? std::abs(x - double(float(x))) : 0;
  };
  switch (node.op) {
    case Op::kParameter:
    case Op::kConstant:
      return by_component(r, r, to_float);
    case Op::kAdd:
    case Op::kSubtract:
    case Op::kMultiply:
    case Op::kScale:
      return absolute(r) * Errors::kRounding;
    case Op::kDivide:
      return absolute(r) * Errors::division();
    case Op::kPower:
      return r.x > 0 && a[0].x > 0 ? absolute(r) * Errors::power(a[0].x, a[1].x) : Vec3d{};
    case Op::kExp:
      return absolute(r) * Errors::exponential(a[0].x);
    case Op::kLog:
      return {Errors::logarithm(a[0].x), 0, 0};
    case Op::kSqrt:
      return absolute(r) * Errors::root();
    case Op::kDot:
      return {3 * Errors::kRounding * dot(absolute(a[0]), absolute(a[1])), 0, 0};
    case Op::kCross: {
      const Vec3d p = absolute(a[0]), q = absolute(a[1]);
      return Vec3d{p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x} *
             (2 * Errors::kRounding);
    }
    case Op::kUnit:
      return absolute(r) * (1.5 * Errors::kRounding + Errors::root() + Errors::division());
    default:
      return {};
  }
}

/// The derivatives by the node's arguments of a number whose derivative by the node's value is
/// `up`. Where a power or a root of zero has no slope, zero is taken to be exact.
inline std::vector<Vec3d> slopes(const Node& node, const std::vector<Vec3d>& a, const Vec3d& r,
                                 const Vec3d& up) {
  const auto where = [&](auto test) {
    return by_component(a[0], a.size() > 1 ? a[1] : Vec3d{},
                        [&](double x, double y) { return test(x, y) ? 1.0 : 0.0; });
  };
  const auto split = [&](const Vec3d& first) {
    return std::vector<Vec3d>{modulate(up, first), modulate(up, Vec3d{1, 1, 1} - first)};
  };
  switch (node.op) {
    case Op::kAdd:
      return {up, up};
    case Op::kSubtract:
      return {up, up * -1.0};
    case Op::kMultiply:
      return {modulate(up, a[1]), modulate(up, a[0])};
    case Op::kMaximum:
      return split(where([](double x, double y) { return x >= y; }));
    case Op::kMinimum:
      return split(where([](double x, double y) { return x <= y; }));
    case Op::kSaturate:
      return {modulate(up, where([](double x, double) { return x >= 0 && x <= 1; }))};
    case Op::kDivide:
      return {up / a[1].x, up * (-r.x / a[1].x)};
    case Op::kPower: {
      if (a[0].x <= 0) return {{}, {}};
      return {up * (a[1].x * r.x / a[0].x), up * (r.x * std::log(a[0].x))};
    }
    case Op::kExp:
      return {up * r.x};
    case Op::kLog:
      return {up / a[0].x};
    case Op::kSqrt:
      return {r.x > 0 ? up / (2 * r.x) : Vec3d{}};
    case Op::kAbs:
      return {a[0].x < 0 ? up * -1.0 : up};
    case Op::kSelectLess: {
      const bool less = a[0].x < a[1].x;
      return {{}, {}, less ? up : Vec3d{}, less ? Vec3d{} : up};
    }
    case Op::kScale:
      return {up * a[1].x, {dot(up, a[0]), 0, 0}};
    case Op::kDot:
      return {a[1] * up.x, a[0] * up.x};
    case Op::kCross:
      return {cross(a[1], up), cross(up, a[0])};
    case Op::kUnit:
      return {dot(a[0], a[0]) > 0 ? (up - r * dot(r, up)) / length(a[0]) : Vec3d{}};
    case Op::kCombine:
      return {{up.x, 0, 0}, {up.y, 0, 0}, {up.z, 0, 0}};
    case Op::kGrey:
      return {{up.x + up.y + up.z, 0, 0}};
    case Op::kX:
      return {{up.x, 0, 0}};
    case Op::kY:
      return {{0, up.x, 0}};
    case Op::kZ:
      return {{0, 0, up.x}};
    default:
      return {};
  }
}

/// The values of all nodes.
inline std::vector<Vec3d> values_of(const Tape& tape, const Inputs& inputs) {
  std::vector<Vec3d> values;
  for (std::size_t i = 0; i < tape.nodes.size(); ++i) {
    std::vector<Vec3d> a;
    for (const std::size_t argument : tape.arguments[i]) a.push_back(values[argument]);
    values.push_back(value_of(*tape.nodes[i], a, inputs));
  }
  return values;
}

/// The largest error of the component of the result in which `component` is 1.
template <class Errors>
double rounding_bound(const Tape& tape, const std::vector<Vec3d>& values, const Vec3d& component) {
  std::vector<Vec3d> moves(values.size());
  moves.back() = component;
  double bound = 0;
  for (std::size_t i = values.size(); i-- > 0;) {
    const std::vector<std::size_t>& arguments = tape.arguments[i];
    std::vector<Vec3d> a;
    for (const std::size_t argument : arguments) a.push_back(values[argument]);
    bound += dot(absolute(moves[i]), own_error<Errors>(*tape.nodes[i], a, values[i]));
    const std::vector<Vec3d> down = slopes(*tape.nodes[i], a, values[i], moves[i]);
    for (std::size_t k = 0; k < down.size(); ++k) {
      moves[arguments[k]] = moves[arguments[k]] + down[k];
    }
  }
  return bound;
}

/// The largest error of each component of the formula's result in single precision.
template <class Errors>
Vec3d rounding_bound(const Tape& tape, const std::vector<Vec3d>& values) {
  return {rounding_bound<Errors>(tape, values, {1, 0, 0}),
          rounding_bound<Errors>(tape, values, {0, 1, 0}),
          rounding_bound<Errors>(tape, values, {0, 0, 1})};
}

}  // namespace lumaknot::rounding
