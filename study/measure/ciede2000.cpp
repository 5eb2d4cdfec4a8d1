#include "study/measure/ciede2000.h"

#include <cmath>

#include "math/angle.h"

namespace lumaknot::measure {
namespace {

/// C^7 / (C^7 + 25^7), which scales both corrections of chroma.
double saturation(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + 6103515625.0));
}

/// Lightness, chroma and hue (radians in [0, 2 pi)), a* stretched: eq. 4 to 7.
struct Polar {
  double lightness, chroma, hue;
};

Polar polar(const Lab<double>& lab, double stretch) {
  const double a = lab.a * stretch;
  const double hue = a == 0 && lab.b == 0 ? 0 : std::atan2(lab.b, a);
  return {lab.lightness, std::hypot(a, lab.b), hue < 0 ? hue + 2 * kPi : hue};
}

/// From the first hue to the second by the shorter way: eq. 10.
double hue_difference(const Polar& first, const Polar& second) {
  if (first.chroma * second.chroma == 0) return 0;
  const double difference = second.hue - first.hue;
  if (difference > kPi) return difference - 2 * kPi;
  return difference < -kPi ? difference + 2 * kPi : difference;
}

/// Half way between the hues: eq. 14.
double mean_hue(const Polar& first, const Polar& second) {
  const double sum = first.hue + second.hue;
  if (first.chroma * second.chroma == 0) return sum;
  if (std::abs(first.hue - second.hue) <= kPi) return sum / 2;
  return (sum < 2 * kPi ? sum + 2 * kPi : sum - 2 * kPi) / 2;
}

/// T of eq. 15.
double hue_weight(double hue) {
  return 1 - 0.17 * std::cos(hue - 30 * kDegree) + 0.24 * std::cos(2 * hue) +
         0.32 * std::cos(3 * hue + 6 * kDegree) - 0.20 * std::cos(4 * hue - 63 * kDegree);
}

/// R_T of eq. 21: how chroma and hue interact in the blues.
double rotation(double hue, double chroma) {
  const double away = (hue / kDegree - 275) / 25;
  return -std::sin(60 * kDegree * std::exp(-away * away)) * 2 * saturation(chroma);
}

}  // namespace

double ciede2000(const Lab<double>& first, const Lab<double>& second) {
  const double chroma_ab = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - saturation(chroma_ab));
  const Polar p = polar(first, stretch), q = polar(second, stretch);
  const double hue_step = 2 * std::sqrt(p.chroma * q.chroma) * std::sin(hue_difference(p, q) / 2);
  const double from_middle = (p.lightness + q.lightness) / 2 - 50;
  const double chroma = (p.chroma + q.chroma) / 2, hue = mean_hue(p, q);
  const double s_l =
      1 + 0.015 * from_middle * from_middle / std::sqrt(20 + from_middle * from_middle);
  const double s_c = 1 + 0.045 * chroma, s_h = 1 + 0.015 * chroma * hue_weight(hue);
  const double l = (q.lightness - p.lightness) / s_l, c = (q.chroma - p.chroma) / s_c;
  const double h = hue_step / s_h;
  return std::sqrt(l * l + c * c + h * h + rotation(hue, chroma) * c * h);
}

}  // namespace lumaknot::measure
