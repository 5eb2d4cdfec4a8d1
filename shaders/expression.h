/// The recorder: a number type that keeps what was computed instead of computing it. A lighting
/// formula run on `Scalar` leaves a graph that a printer turns into another tool's language.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "scene/vec.h"
#include "shaders/number.h"

namespace lumaknot {

/// What a node of the graph does. Scalars and vectors share the operations; `kScale` is vector by
/// scalar, `kCombine` makes a vector of three scalars.
enum class Op {
  kInput,      ///< a value of the surface, by `name`
  kParameter,  ///< a number of the scene, by `name`, now `value`
  kConstant,   ///< a number of the formula
  kAdd,
  kSubtract,
  kMultiply,
  kMaximum,
  kMinimum,
  kPower,
  kScale,
  kDot,
  kUnit,
  kCombine
};

/// One step of a recorded formula. Immutable; arguments are shared where the formula shares them.
struct Node {
  Op op = Op::kConstant;
  bool is_vector = false;
  std::vector<std::shared_ptr<const Node>> arguments;
  Vec3d value;  ///< of a parameter or constant; a scalar in x
  std::string
      name;  ///< of an input or parameter, or what the formula calls the value; may be empty
};

using NodePtr = std::shared_ptr<const Node>;

/// A recorded scalar.
struct Scalar {
  NodePtr node;
  Scalar(double constant);  // implicit: numbers of a formula read as such
  explicit Scalar(NodePtr n) : node(std::move(n)) {}
};

/// A recorded vector of three components.
struct ScalarVec {
  NodePtr node;
};

template <>
struct VecOf<Scalar> {
  using type = ScalarVec;
};

/// The surface's `name` (position, normal, texture).
ScalarVec vector_input(std::string name);

/// Numbers of the scene that keep their name in the printed code.
Scalar scalar_parameter(std::string name, double value);
ScalarVec vector_parameter(std::string name, const Vec3d& value);

Scalar operator+(const Scalar& a, const Scalar& b);
Scalar operator-(const Scalar& a, const Scalar& b);
Scalar operator*(const Scalar& a, const Scalar& b);
ScalarVec operator+(const ScalarVec& a, const ScalarVec& b);
ScalarVec operator-(const ScalarVec& a, const ScalarVec& b);
ScalarVec operator*(const ScalarVec& v, const Scalar& s);

Scalar max(const Scalar& a, const Scalar& b);
Scalar saturate(const Scalar& x);
ScalarVec saturate(const ScalarVec& v);
Scalar power(const Scalar& base, const Scalar& exponent);
Scalar dot(const ScalarVec& a, const ScalarVec& b);
ScalarVec unit(const ScalarVec& v);
ScalarVec make_vec(const Scalar& x, const Scalar& y, const Scalar& z);
Scalar named(const char* name, const Scalar& x);
ScalarVec named(const char* name, const ScalarVec& v);

/// The nodes that `root` needs, arguments before their users, each once. They live as long as
/// `root`.
std::vector<const Node*> in_order(const NodePtr& root);

}  // namespace lumaknot
