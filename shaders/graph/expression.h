/// The recorder: a number type that keeps what was computed instead of computing it. A lighting
/// formula run on `Scalar` leaves a graph that a printer turns into another tool's language.
///
/// Where languages may give different results, recording throws std::logic_error: the power or root
/// of a number that may be negative, the logarithm of one that may be zero. Arithmetic on
/// constants, and with 0 and 1, is evaluated immediately, so what a scene does not need leaves no
/// trace; powers, roots and logarithms are never computed here.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "math/number.h"
#include "math/vec.h"

namespace lumaknot {

/// The operation of a node. Scalars and vectors share the operations down to kSaturate, vectors
/// component by component.
enum class Op {
  kInput,      ///< a value of the surface, by `name`
  kParameter,  ///< a number of the scene, by `name`, now `value`
  kConstant,   ///< a number of the formula
  kAdd,
  kSubtract,
  kMultiply,
  kMaximum,
  kMinimum,
  kSaturate,
  kDivide,  ///< this and the following: of scalars
  kPower,
  kExp,
  kLog,
  kSqrt,
  kAbs,
  kSelectLess,  ///< a < b ? x : y
  kScale,       ///< vector by scalar
  kDot,
  kCross,
  kUnit,     ///< zero stays zero
  kCombine,  ///< a vector of three scalars
  kGrey,     ///< a vector with all components one scalar
  kX,        ///< a vector's component
  kY,
  kZ
};

/// One step of a recorded formula. Immutable; arguments are shared where the formula shares them.
struct Node {
  Op op = Op::kConstant;
  bool is_vector = false;
  std::vector<std::shared_ptr<const Node>> arguments;
  Vec3d value;  ///< of a parameter or constant; a scalar in x
  double min = -std::numeric_limits<double>::infinity();  ///< a known lower bound
  std::string name;  ///< of an input or parameter, or the value's name in the formula; may be empty
};

using NodePtr = std::shared_ptr<const Node>;

/// A recorded scalar.
struct Scalar {
  NodePtr node;
  Scalar(double constant);  // implicit, so that formulas can use plain numbers
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
Scalar scalar_input(std::string name);
ScalarVec vector_input(std::string name);

/// Numbers of the scene that keep their name in the printed code.
Scalar scalar_parameter(std::string name, double value);
ScalarVec vector_parameter(std::string name, const Vec3d& value);

Scalar operator+(const Scalar& a, const Scalar& b);
Scalar operator-(const Scalar& a, const Scalar& b);
Scalar operator*(const Scalar& a, const Scalar& b);
Scalar operator/(const Scalar& a, const Scalar& b);
ScalarVec operator+(const ScalarVec& a, const ScalarVec& b);
ScalarVec operator-(const ScalarVec& a, const ScalarVec& b);
ScalarVec operator*(const ScalarVec& v, const Scalar& s);

Scalar max(const Scalar& a, const Scalar& b);
Scalar min(const Scalar& a, const Scalar& b);
Scalar abs(const Scalar& x);
Scalar sqrt(const Scalar& x);
Scalar exp(const Scalar& x);
Scalar log(const Scalar& x);
Scalar power(const Scalar& base, const Scalar& exponent);
Scalar select_less(const Scalar& a, const Scalar& b, const Scalar& x, const Scalar& y);
Scalar saturate(const Scalar& x);
ScalarVec saturate(const ScalarVec& v);
ScalarVec modulate(const ScalarVec& a, const ScalarVec& b);
Scalar dot(const ScalarVec& a, const ScalarVec& b);
ScalarVec cross(const ScalarVec& a, const ScalarVec& b);
ScalarVec unit(const ScalarVec& v);
ScalarVec make_vec(const Scalar& x, const Scalar& y, const Scalar& z);
ScalarVec grey(const Scalar& x);
Scalar x_of(const ScalarVec& v);
Scalar y_of(const ScalarVec& v);
Scalar z_of(const ScalarVec& v);
Scalar named(const char* name, const Scalar& x);
ScalarVec named(const char* name, const ScalarVec& v);

/// The nodes that `roots` need, arguments before their users, each once. They live as long as
/// `roots`.
std::vector<const Node*> in_order(const std::vector<NodePtr>& roots);

}  // namespace lumaknot
