/// Fixed-seed inputs for lighting formulas, the same on every machine.
#pragma once

#include <random>

#include "shaders/lighting.h"

namespace lumaknot {

/// Numbers and surface points from one seed. The distributions of <random> differ between
/// libraries; the generator does not.
class RandomSurface {
 public:
  double number(double low, double high) {
    return low + (high - low) * (double(generator_()) / 4294967296.0);
  }
  Vec3d vector(double low, double high) {
    const double x = number(low, high), y = number(low, high);
    return {x, y, number(low, high)};
  }
  /// A point near the origin whose normal is up to a tenth too short, as interpolation leaves it.
  SurfacePoint<double> point() {
    const Vec3d position = vector(-1, 1);
    Vec3d normal = vector(-1, 1);
    while (length(normal) < 0.1) normal = vector(-1, 1);
    normal = normalize(normal) * number(0.9, 1);
    return {position, normal, vector(0, 1)};
  }
  /// Eye and light outside the points' cube.
  Lighting<double> lighting() {
    const Vec3d eye = normalize(vector(0.1, 1)) * number(3, 6);
    const Vec3d light = normalize(vector(-1, -0.1)) * number(3, 6);
    return {eye, number(0, 1) < 0.5 ? light : -light, 0.1, 0.9, 0.8, 55, -0.1};
  }

 private:
  std::mt19937 generator_{20260101};
};

inline Vec3<float> narrowed(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

}  // namespace lumaknot
