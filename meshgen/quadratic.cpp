#include "meshgen/quadratic.h"

#include <algorithm>

namespace lumaknot {
namespace {

/// The minimiser of slope x + second x^2 / 2 for |x| <= max.
double min_on_line(double slope, double second, double max) {
  if (second > 0) return std::clamp(-slope / second, -max, max);
  return slope > 0 ? -max : max;
}

}  // namespace

Minimum min_in_box(const Quadratic& f, double x_max, double y_max) {
  Minimum min{0, 0, f.value};
  const auto consider = [&](double x, double y) {
    if (const double value = f(x, y); value < min.value) min = {x, y, value};
  };
  // On the sides, then inside.
  for (const double x : {-x_max, x_max}) {
    consider(x, min_on_line(f.y_slope + f.xy * x, f.yy, y_max));
  }
  for (const double y : {-y_max, y_max}) {
    consider(min_on_line(f.x_slope + f.xy * y, f.xx, x_max), y);
  }
  const double determinant = f.xx * f.yy - f.xy * f.xy;
  if (f.xx > 0 && determinant > 0) {
    consider(std::clamp((f.xy * f.y_slope - f.yy * f.x_slope) / determinant, -x_max, x_max),
             std::clamp((f.xy * f.x_slope - f.xx * f.y_slope) / determinant, -y_max, y_max));
  }
  return min;
}

}  // namespace lumaknot
