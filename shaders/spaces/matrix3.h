/// 3 x 3 matrices for formulas: constants in double, applied to any number type.
#pragma once

#include "math/number.h"

namespace lumaknot {

struct Matrix3 {
  Vec3d rows[3];
};

/// The matrix whose rows are `m`'s, each times its component of `factors`.
constexpr Matrix3 scale_rows(const Matrix3& m, const Vec3d& factors) {
  return {{m.rows[0] * factors.x, m.rows[1] * factors.y, m.rows[2] * factors.z}};
}

/// The matrix whose columns are `m`'s, each times its component of `factors`.
constexpr Matrix3 scale_columns(const Matrix3& m, const Vec3d& factors) {
  const auto scaled = [&](const Vec3d& row) {
    return Vec3d{row.x * factors.x, row.y * factors.y, row.z * factors.z};
  };
  return {{scaled(m.rows[0]), scaled(m.rows[1]), scaled(m.rows[2])}};
}

/// By cofactors; `m` must not be singular.
constexpr Matrix3 inverse(const Matrix3& m) {
  const Vec3d a = cross(m.rows[1], m.rows[2]);
  const Vec3d b = cross(m.rows[2], m.rows[0]);
  const Vec3d c = cross(m.rows[0], m.rows[1]);
  const double determinant = dot(m.rows[0], a);
  return {{Vec3d{a.x, b.x, c.x} / determinant, Vec3d{a.y, b.y, c.y} / determinant,
           Vec3d{a.z, b.z, c.z} / determinant}};
}

/// m v.
template <class S>
Vec<S> transform(const Matrix3& m, const Vec<S>& v) {
  return make_vec(dot(constant_vec<S>(m.rows[0]), v), dot(constant_vec<S>(m.rows[1]), v),
                  dot(constant_vec<S>(m.rows[2]), v));
}

}  // namespace lumaknot
