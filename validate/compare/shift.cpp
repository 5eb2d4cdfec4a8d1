#include "validate/compare/shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumaknot::validate {
namespace {

double weight_of(const PixelError& pixel) {
  const double scale = std::max(pixel.limit, pixel.error);
  return 1 / (scale * scale);
}

}  // namespace

double Shift::size() const { return std::max(std::abs(x), std::abs(y)); }

Shift fitted_shift(const std::vector<PixelError>& pixels) {
  // A picture that lies at (x, y) shows what ours shows at (-x, -y): its error is -slope * shift.
  double xx = 0, xy = 0, yy = 0, ex = 0, ey = 0;
  for (const PixelError& p : pixels) {
    if (!p.inside) continue;
    const double weight = weight_of(p);
    xx += weight * p.slope_x * p.slope_x;
    xy += weight * p.slope_x * p.slope_y;
    yy += weight * p.slope_y * p.slope_y;
    ex -= weight * p.signed_error * p.slope_x;
    ey -= weight * p.signed_error * p.slope_y;
  }
  Shift shift;
  const double determinant = xx * yy - xy * xy;
  shift.deviation = std::numeric_limits<double>::infinity();
  if (!(determinant > 1e-6 * xx * yy)) return shift;
  shift.x = (ex * yy - ey * xy) / determinant;
  shift.y = (ey * xx - ex * xy) / determinant;
  shift.deviation = std::sqrt(std::max(xx, yy) / determinant);
  double before = 0, after = 0;
  for (const PixelError& p : pixels) {
    if (!p.inside) continue;
    const double rest = p.signed_error + p.slope_x * shift.x + p.slope_y * shift.y;
    before += weight_of(p) * p.signed_error * p.signed_error;
    after += weight_of(p) * rest * rest;
  }
  shift.explained = before > 0 ? 1 - after / before : 0;
  return shift;
}

}  // namespace lumaknot::validate
