/// A number type's highlight, and its error.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/image.h"
#include "shaders/formulas/terms.h"

namespace lumaknot::stability {

/// Phong's highlight in S and in double where one is seen.
struct TwoHighlights {
  double computed = 0, exact = 0;
};

/// On the `i`th of some normals, seen from `along` and `beside` the mirror direction, in units of
/// the angle at which the highlight is 1 % of its peak.
template <class S>
TwoHighlights highlights_at(double shininess, int i, double along, double beside = 0) {
  const double a = 2.4 * i, unit = std::sqrt(2 * std::log(100) / shininess);
  const Vec3d n = normalize(Vec3d{std::cos(a), std::sin(a), 0.3 + 0.1 * i});
  const Vec3d x = normalize(cross(n, Vec3d{0, 0, 1})), l = n * 0.8 + x * 0.6;
  const Vec3d mirror = n * 0.8 - x * 0.6, across = n * 0.6 + x * 0.8, other = cross(n, x);
  const double angle = unit * std::hypot(along, beside), turn = std::atan2(beside, along);
  const Vec3d side = across * std::cos(turn) + other * std::sin(turn);
  const Vec3d v = mirror * std::cos(angle) + side * std::sin(angle);
  const Vec<S> ns = constant_vec<S>(n), ls = constant_vec<S>(l);
  const S highlight =
      PhongHighlight::value<S>({ns, ls, constant_vec<S>(v), dot(ns, ls)}, S(shininess));
  return {double(highlight), PhongHighlight::value<double>({n, l, v, dot(n, l)}, shininess)};
}

/// The largest difference of Phong's highlight in S from double, its peak seen from where it is
/// above 1 %, on some normals.
template <class S>
double peak_error(double shininess) {
  constexpr int kNormals = 20, kAngles = 40;
  double largest = 0;
  for (int i = 0; i < kNormals; ++i) {
    for (int j = 0; j < kAngles; ++j) {
      const TwoHighlights h = highlights_at<S>(shininess, i, double(j) / kAngles);
      largest = std::max(largest, std::abs(h.computed - h.exact));
    }
  }
  return largest;
}

/// The highlight in S on the first of those normals out to where it is 1 %: as large whatever the
/// shininess.
template <class S>
Image peak_sketch(double shininess, int side) {
  Image image(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto at = [&](int k) { return (2 * k + 1.0) / side - 1; };
      const float h = float(highlights_at<S>(shininess, 0, at(x), at(y)).computed);
      image.at(x, y) = {{h, h, h}, 1};
    }
  }
  return image;
}

}  // namespace lumaknot::stability
