/// Quadratic functions of two variables, and where they are least in a rectangle.
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
struct Least {
  double x, y, value;
};

/// Where `f` is least for |x| <= x_most and |y| <= y_most.
Least least_in_box(const Quadratic& f, double x_most, double y_most);

}  // namespace lumaknot
