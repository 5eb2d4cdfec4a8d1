#include "diagnosis/colors.h"

#include <cmath>

#include "shaders/spaces/srgb.h"
#include "shaders/spaces/yiq.h"

namespace lumaknot::diagnosis {
namespace {

template <class F>
Vec3d each(const Vec3d& c, F f) {
  return {f(c.x), f(c.y), f(c.z)};
}

Vec3d rotated_hue(const Vec3d& color, double angle) {
  if (angle == 0) return color;
  Yiq<double> yiq = yiq_from_rgb<double>(color);
  const double c = std::cos(angle), s = std::sin(angle);
  yiq = {yiq.y, c * yiq.i - s * yiq.q, s * yiq.i + c * yiq.q};
  return rgb_from_yiq(yiq);
}

double rounded(double x, int levels) {
  return std::round(std::clamp(x, 0.0, 1.0) * (levels - 1)) / (levels - 1);
}

/// Gamma and curve of one channel below zero, if they are not odd.
double below_zero(const ColorUse& use, double x) {
  if (use.below == Below::kZero) return 0;
  if (use.curve == Curve::kEncodeSrgb) return 12.92 * x;
  return use.curve == Curve::kDecodeSrgb ? x / 12.92 : x;
}

Vec3d transferred(const ColorUse& use, const Vec3d& color) {
  const Vec3d odd = curved(use.curve, powered(color, 1 / use.gamma));
  if (use.below == Below::kOdd) return odd;
  const auto either = [&](double x, double y) { return x < 0 ? below_zero(use, x) : y; };
  return {either(color.x, odd.x), either(color.y, odd.y), either(color.z, odd.z)};
}

Vec3d applied(const ColorUse& use, const Vec3d& color, double coverage) {
  const Vec3d gained = modulate(use.gain, color);
  Vec3d c = each(gained, [&](double x) {
    return (x + use.offset * coverage - 0.5 * coverage) * use.contrast + 0.5 * coverage;
  });
  c = rotated_hue(saturated(c, use.saturation), use.hue);
  c = toned(use.tone, use.primaries * c);
  if (!use.spline_values.empty()) {
    c = each(c, [&](double x) { return use.spline.at(x, use.spline_values); });
  }
  c = permuted(use.channels, transferred(use, c));
  if (use.inverted) c = Vec3d{1, 1, 1} * coverage - c;
  if (use.limited) c = each(c, [](double x) { return std::clamp(x, 0.0, 1.0); });
  if (use.levels > 0) c = each(c, [&](double x) { return rounded(x, use.levels); });
  return use.by_alpha == 0 ? c : c * std::pow(coverage, use.by_alpha);
}

}  // namespace

Vec3d powered(const Vec3d& color, double exponent) {
  if (exponent == 1) return color;
  return each(color, [&](double x) { return std::copysign(std::pow(std::abs(x), exponent), x); });
}

Vec3d curved(Curve curve, const Vec3d& color) {
  switch (curve) {
    case Curve::kEncodeSrgb:
      return each(color, [](double x) { return encode_srgb<double>(x); });
    case Curve::kDecodeSrgb:
      return each(color, [](double x) { return decode_srgb<double>(x); });
    case Curve::kNone:
      break;
  }
  return color;
}

Vec3d permuted(const std::array<std::size_t, 3>& channels, const Vec3d& color) {
  const std::array<double, 3> c = components(color);
  return {c[channels[0]], c[channels[1]], c[channels[2]]};
}

Vec3d saturated(const Vec3d& color, double saturation) {
  if (saturation == 1) return color;
  const double luma = yiq_from_rgb<double>(color).y;
  const Vec3d grey{luma, luma, luma};
  return grey + (color - grey) * saturation;
}

void apply(const ColorUse& use, std::span<Vec3d> colors, std::span<const double> coverage) {
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (coverage[i] > 0) colors[i] = applied(use, colors[i], coverage[i]);
  }
}

}  // namespace lumaknot::diagnosis
