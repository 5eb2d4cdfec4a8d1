/// Random formulas of every operation that the recorder knows, from a fixed seed.
#pragma once

#include <vector>

#include "shaders/graph/expression.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/graph/evaluate.h"

namespace lumaknot {

/// Graphs over the inputs x, y, z (scalars), u, v (vectors) and the parameters p (scalar) and
/// w (vector). Values stay finite and moderate: divisors and bases keep away from zero.
class RandomGraph {
 public:
  explicit RandomGraph(std::uint32_t seed) : random_(seed) {}

  Scalar scalar(int depth) {
    const Scalar made = depth <= 0 ? leaf() : step(depth);
    scalars_.push_back(made);
    if (scalars_.size() > 12) scalars_.erase(scalars_.begin());
    return made;
  }

  ScalarVec vector(int depth) {
    if (depth <= 0) return vector_leaf();
    switch (random_.index(9)) {
      case 0:
        return vector(depth - 1) + vector(depth - 1);
      case 1:
        return vector(depth - 1) - vector(depth - 1);
      case 2:
        return modulate(vector(depth - 1), vector(depth - 1));
      case 3:
        return saturate(vector(depth - 1)) * scalar(depth - 1);
      case 4:
        return cross(saturate(vector(depth - 1)), vector(depth - 1));
      case 5:
        return unit(vector(depth - 1));
      case 6: {
        const Scalar x = scalar(depth - 1), y = scalar(depth - 1);
        return make_vec(x, y, scalar(depth - 1));
      }
      case 7:
        return named("vector_name", vector(depth - 1));
      default:
        return grey(scalar(depth - 1));
    }
  }

  /// Values of all inputs.
  Inputs inputs() {
    Inputs values;
    for (const char* name : {"x", "y", "z"}) values[name] = {random_.number(-2, 2), 0, 0};
    for (const char* name : {"u", "v"}) values[name] = random_.vector(-2, 2);
    return values;
  }

 private:
  Scalar leaf() {
    switch (random_.index(6)) {
      case 0:
        return scalar_input("x");
      case 1:
        return scalar_input("y");
      case 2:
        return scalar_input("z");
      case 3:
        return scalar_parameter("p", 0.75);
      case 4:
        return random_.number(-2, 2);
      default:
        return double(random_.index(5)) - 2;
    }
  }
  ScalarVec vector_leaf() {
    switch (random_.index(4)) {
      case 0:
        return vector_input("u");
      case 1:
        return vector_input("v");
      case 2:
        return vector_parameter("w", {0.25, -0.5, 1.5});
      default:
        return constant_vec<Scalar>(random_.vector(-1, 1));
    }
  }
  Scalar step(int depth) { return random_.index(2) ? arithmetic(depth - 1) : function(depth - 1); }
  Scalar arithmetic(int depth) {
    switch (random_.index(5)) {
      case 0:
        return scalar(depth) + scalar(depth);
      case 1:
        return scalar(depth) - scalar(depth);
      case 2:
        return saturate(scalar(depth)) * scalar(depth);
      case 3:
        return scalar(depth) / (abs(scalar(depth)) + 0.5);
      default:
        return shared();
    }
  }
  /// A scalar created before, so that graphs are not trees.
  Scalar shared() { return scalars_.empty() ? leaf() : scalars_[random_.index(scalars_.size())]; }

  Scalar function(int depth) {
    switch (random_.index(12)) {
      case 0:
        return max(scalar(depth), scalar(depth));
      case 1:
        return min(scalar(depth), scalar(depth));
      case 2:
        return saturate(scalar(depth));
      case 3:
        return power(abs(scalar(depth)) + 0.125, saturate(scalar(depth)));
      case 4:
        return power(saturate(scalar(depth)), abs(scalar(depth)));
      case 5:
        return exp(min(scalar(depth), 2));
      case 6:
        return log(abs(scalar(depth)) + 0.5);
      case 7:
        return sqrt(abs(scalar(depth)));
      case 8: {
        const Scalar a = scalar(depth), b = scalar(depth), x = scalar(depth);
        return select_less(a, b, x, scalar(depth));
      }
      case 9:
        return dot(vector(depth), unit(vector(depth)));
      case 10:
        return named("scalar_name", scalar(depth));
      default:
        return component(vector(depth));
    }
  }
  Scalar component(const ScalarVec& v) {
    const std::size_t i = random_.index(3);
    return i == 0 ? x_of(v) : i == 1 ? y_of(v) : z_of(v);
  }

  RandomSurface random_;
  std::vector<Scalar> scalars_;
};

}  // namespace lumaknot
