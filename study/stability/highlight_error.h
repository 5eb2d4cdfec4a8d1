/// The error of a number type's highlight.
#pragma once

#include <algorithm>
#include <cmath>

#include "shaders/formulas/terms.h"

namespace lumaknot::stability {

/// The largest difference of Phong's highlight in S from double, its peak seen from where it is
/// above 1 %, on some normals.
template <class S>
double peak_error(double shininess) {
  constexpr int kNormals = 20, kAngles = 40;
  double largest = 0;
  for (int i = 0; i < kNormals; ++i) {
    const double a = 2.4 * i;
    const Vec3d n = normalize(Vec3d{std::cos(a), std::sin(a), 0.3 + 0.1 * i});
    const Vec3d x = normalize(cross(n, Vec3d{0, 0, 1})), l = n * 0.8 + x * 0.6;
    const Vec3d mirror = n * 0.8 - x * 0.6, across = n * 0.6 + x * 0.8;
    for (int j = 0; j < kAngles; ++j) {
      const double angle = std::sqrt(2 * std::log(100) / shininess) * j / kAngles;
      const Vec3d v = mirror * std::cos(angle) + across * std::sin(angle);
      const Vec<S> ns = constant_vec<S>(n), ls = constant_vec<S>(l);
      const S highlight =
          PhongHighlight::value<S>({ns, ls, constant_vec<S>(v), dot(ns, ls)}, S(shininess));
      const double exact = PhongHighlight::value<double>({n, l, v, dot(n, l)}, shininess);
      largest = std::max(largest, std::abs(double(highlight) - exact));
    }
  }
  return largest;
}

}  // namespace lumaknot::stability
