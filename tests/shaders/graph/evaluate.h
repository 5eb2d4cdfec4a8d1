/// Runs recorded graphs in double: the reference for printed code and other instances.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "shaders/formulas/lighting.h"
#include "shaders/graph/record.h"

namespace lumaknot {

/// Values of a graph's inputs by name; a scalar in x.
using Inputs = std::map<std::string, Vec3d>;

namespace testing_evaluate {

template <class F>
Vec3d each(const Vec3d& a, F f) {
  return {f(a.x), f(a.y), f(a.z)};
}

template <class F>
Vec3d each(const Vec3d& a, const Vec3d& b, F f) {
  return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}

inline Vec3d unit_or_zero(const Vec3d& v) {
  const double size = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return size > 0 ? Vec3d{v.x / size, v.y / size, v.z / size} : v;
}

/// One node on its arguments' values. Scalars have zeros in y and z, and so must the result.
inline Vec3d run(const Node& node, const std::vector<Vec3d>& a, const Inputs& inputs) {
  switch (node.op) {
    case Op::kInput:
      return inputs.at(node.name);
    case Op::kParameter:
    case Op::kConstant:
      return node.value;
    case Op::kAdd:
      return each(a[0], a[1], [](double x, double y) { return x + y; });
    case Op::kSubtract:
      return each(a[0], a[1], [](double x, double y) { return x - y; });
    case Op::kMultiply:
      return each(a[0], a[1], [](double x, double y) { return x * y; });
    case Op::kMaximum:
      return each(a[0], a[1], [](double x, double y) { return x < y ? y : x; });
    case Op::kMinimum:
      return each(a[0], a[1], [](double x, double y) { return y < x ? y : x; });
    case Op::kSaturate:
      return each(a[0], [](double x) { return x < 0 ? 0 : x > 1 ? 1 : x; });
    case Op::kDivide:
      return {a[0].x / a[1].x, 0, 0};
    case Op::kPower:
      return {std::pow(a[0].x, a[1].x), 0, 0};
    case Op::kExp:
      return {std::exp(a[0].x), 0, 0};
    case Op::kLog:
      return {std::log(a[0].x), 0, 0};
    case Op::kSqrt:
      return {std::sqrt(a[0].x), 0, 0};
    case Op::kAbs:
      return {std::fabs(a[0].x), 0, 0};
    case Op::kSelectLess:
      return a[0].x < a[1].x ? a[2] : a[3];
    case Op::kScale:
      return each(a[0], [&](double x) { return x * a[1].x; });
    case Op::kDot:
      return {a[0].x * a[1].x + a[0].y * a[1].y + a[0].z * a[1].z, 0, 0};
    case Op::kCross:
      return {a[0].y * a[1].z - a[0].z * a[1].y, a[0].z * a[1].x - a[0].x * a[1].z,
              a[0].x * a[1].y - a[0].y * a[1].x};
    case Op::kUnit:
      return unit_or_zero(a[0]);
    case Op::kCombine:
      return {a[0].x, a[1].x, a[2].x};
    case Op::kGrey:
      return {a[0].x, a[0].x, a[0].x};
    case Op::kX:
      return {a[0].x, 0, 0};
    case Op::kY:
      return {a[0].y, 0, 0};
    case Op::kZ:
      return {a[0].z, 0, 0};
  }
  throw std::logic_error("an operation without a meaning");
}

}  // namespace testing_evaluate

/// The values of `roots` for `inputs`. Throws when an input is missing or a node comes before its
/// arguments.
inline std::vector<Vec3d> evaluate(const std::vector<NodePtr>& roots, const Inputs& inputs) {
  std::unordered_map<const Node*, Vec3d> values;
  for (const Node* node : in_order(roots)) {
    std::vector<Vec3d> arguments;
    for (const NodePtr& argument : node->arguments) arguments.push_back(values.at(argument.get()));
    values[node] = testing_evaluate::run(*node, arguments, inputs);
  }
  std::vector<Vec3d> results;
  for (const NodePtr& root : roots) results.push_back(values.at(root.get()));
  return results;
}

inline Vec3d evaluate(const NodePtr& root, const Inputs& inputs) {
  return evaluate(std::vector<NodePtr>{root}, inputs)[0];
}

/// The colour of a recorded shot where the surface has `inputs`; its varyings are computed there
/// too, as if at a vertex.
inline Vec3d evaluate(const Recorded& recorded, Inputs inputs) {
  const Inputs at_vertex = inputs;
  for (const Varying& v : recorded.varyings) inputs[v.name] = evaluate(v.value, at_vertex);
  return evaluate(recorded.color, inputs);
}

/// What recorded shots read of a surface; `texture` as r'g'b', on the axes where `material` is
/// baked.
inline Inputs surface_inputs(const SurfacePoint<double>& point, const Vec3d& texture,
                             const Material& material) {
  const bool baked = material.form == Form::kBaked;
  return {{"position", point.position},
          {"normal", point.normal},
          {baked ? "texture_axes" : "texture", texture_value(texture, material)}};
}

}  // namespace lumaknot
