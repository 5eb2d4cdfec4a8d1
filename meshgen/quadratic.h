/// Quadratic functions of two variables and their minima in a rectangle.
#pragma once

namespace lumaknot {

/// value + x_slope x + y_slope y + (xx x^2 + 2 xy x y + yy y^2) / 2.
struct Quadratic {
  double value, x_slope, y_slope, xx, xy, yy;

  double operator()(double x, double y) const {
    return value + x * (x_slope + xx * x / 2 + xy * y) + y * (y_slope + yy * y / 2);
  }
};

/// A place and the value there.
struct Minimum {
  double x, y, value;
};

/// The minimum of `f` for |x| <= x_max and |y| <= y_max.
Minimum min_in_box(const Quadratic& f, double x_max, double y_max);

}  // namespace lumaknot
