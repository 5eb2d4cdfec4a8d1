/// Matrices of colours.
#pragma once

#include <array>

#include "math/vec.h"

namespace lumaknot::diagnosis {

/// The three rows of a matrix.
using Rows = std::array<Vec3d, 3>;

constexpr Vec3d operator*(const Rows& m, const Vec3d& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

}  // namespace lumaknot::diagnosis
