#include "meshgen/quadratic.h"

#include <algorithm>

namespace lumaknot {
namespace {

/// Where slope x + second x^2 / 2 is least for |x| <= most.
double least_on_line(double slope, double second, double most) {
  if (second > 0) return std::clamp(-slope / second, -most, most);
  return slope > 0 ? -most : most;
}

}  // namespace

Least least_in_box(const Quadratic& f, double x_most, double y_most) {
  Least least{0, 0, f.value};
  const auto consider = [&](double x, double y) {
    if (const double value = f(x, y); value < least.value) least = {x, y, value};
  };
  // On the sides, then within.
  for (const double x : {-x_most, x_most}) {
    consider(x, least_on_line(f.y_slope + f.xy * x, f.yy, y_most));
  }
  for (const double y : {-y_most, y_most}) {
    consider(least_on_line(f.x_slope + f.xy * y, f.xx, x_most), y);
  }
  const double determinant = f.xx * f.yy - f.xy * f.xy;
  if (f.xx > 0 && determinant > 0) {
    consider(std::clamp((f.xy * f.y_slope - f.yy * f.x_slope) / determinant, -x_most, x_most),
             std::clamp((f.xy * f.x_slope - f.xx * f.y_slope) / determinant, -y_most, y_most));
  }
  return least;
}

}  // namespace lumaknot
