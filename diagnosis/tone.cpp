#include "diagnosis/tone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/rows.h"

namespace lumaknot::diagnosis {
namespace {

template <class F>
Vec3d each(const Vec3d& c, F f) {
  return {f(c.x), f(c.y), f(c.z)};
}

double limited(double x) { return std::clamp(x, 0.0, 1.0); }

/// K. Narkowicz, ACES Filmic Tone Mapping Curve, 2015.
double aces(double x) { return limited((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14)); }

/// S. Hill's fit of ACES' reference rendering and output transforms (the BakingLab sample, 2016),
/// brightened by 1 / 0.6 as three.js has it.
Vec3d aces_fitted(const Vec3d& color) {
  constexpr Rows kIn{
      {{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}}};
  constexpr Rows kOut{{{1.60475, -0.53108, -0.07367},
                       {-0.10208, 1.10813, -0.00605},
                       {-0.00327, -0.07276, 1.07602}}};
  const auto fit = [](double v) {
    return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  };
  return each(kOut * each(kIn * (color / 0.6), fit), limited);
}

/// J. Hable, Filmic Tonemapping Operators, 2010: white at 11.2, an exposure of 2.
double hable(double x) {
  const auto curve = [](double v) {
    constexpr double a = 0.15, b = 0.5, c = 0.1, d = 0.2, e = 0.02, f = 0.3;
    return (v * (a * v + c * b) + d * e) / (v * (a * v + b) + d * f) - e / f;
  };
  return curve(2 * x) / curve(11.2);
}

/// Khronos PBR Neutral Tone Mapper, 2024.
Vec3d neutral(const Vec3d& color) {
  constexpr double kStart = 0.8 - 0.04, kDesaturation = 0.15;
  const double low = std::min({color.x, color.y, color.z});
  const double offset = low < 0.08 ? low - 6.25 * low * low : 0.04;
  const Vec3d c = color - Vec3d{offset, offset, offset};
  const double peak = std::max({c.x, c.y, c.z});
  if (peak < kStart) return c;
  constexpr double d = 1 - kStart;
  const double compressed = 1 - d * d / (peak + d - kStart);
  const double grey = 1 - 1 / (kDesaturation * (peak - compressed) + 1);
  return c * (compressed / peak) * (1 - grey) + Vec3d{compressed, compressed, compressed} * grey;
}

/// T. Sobotka's AgX with B. Wrensch's polynomial, over Rec. 2020 as Filament and three.js have it.
Vec3d agx(const Vec3d& color) {
  constexpr Rows kToWide{
      {{0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0113}, {0.0164, 0.0880, 0.8956}}};
  constexpr Rows kFromWide{
      {{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}};
  constexpr Rows kInset{{{0.856627153315983, 0.0951212405381588, 0.0482516061458583},
                         {0.137318972929847, 0.761241990602591, 0.101439036467562},
                         {0.11189821299995, 0.0767994186031903, 0.811302368396859}}};
  constexpr Rows kOutset{{{1.1271005818144368, -0.11060664309660323, -0.016493938717834573},
                          {-0.1413297634984383, 1.157823702216272, -0.016493938717834257},
                          {-0.14132976349843826, -0.11060664309660294, 1.2519364065950405}}};
  const auto contrast = [](double v) {
    constexpr double kMin = -12.47393, kMax = 4.026069;
    const double x = limited((std::log2(std::max(v, 1e-10)) - kMin) / (kMax - kMin));
    constexpr std::array kPowers{-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5};
    double sum = 0;
    for (std::size_t i = kPowers.size(); i-- > 0;) sum = sum * x + kPowers[i];
    return sum;
  };
  const Vec3d shown = kOutset * each(kInset * (kToWide * color), contrast);
  const Vec3d linear = each(shown, [](double x) { return std::pow(std::max(x, 0.0), 2.2); });
  return each(kFromWide * linear, limited);
}

/// J. Hejl and R. Burgess-Dawson's fit of a Cineon film's response, without its display's gamma.
double cineon(double value) {
  const double x = std::max(0.0, value - 0.004);
  return std::pow((x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06), 2.2);
}

}  // namespace

Vec3d toned(Tone tone, const Vec3d& color) {
  switch (tone) {
    case Tone::kReinhard:
      return each(color, [](double x) { return x / (1 + std::max(x, 0.0)); });
    case Tone::kAces:
      return each(color, aces);
    case Tone::kAcesFitted:
      return aces_fitted(color);
    case Tone::kHable:
      return each(color, hable);
    case Tone::kNeutral:
      return neutral(color);
    case Tone::kAgx:
      return agx(color);
    case Tone::kCineon:
      return each(color, cineon);
    case Tone::kNone:
      break;
  }
  return color;
}

ToneSpline::Weights ToneSpline::weights(double x, std::size_t count) const {
  const double last = double(count - 1), root = std::copysign(std::sqrt(std::abs(x)), x);
  const double t = limited((root - low) / (high - low)) * last;
  const auto k = std::min(std::size_t(t), count - 2);
  const double f = t - double(k);
  // Catmull and Rom's cubic, with the end points mirrored through their neighbours.
  std::array<double, 4> w{-0.5 * f + f * f - 0.5 * f * f * f, 1 - 2.5 * f * f + 1.5 * f * f * f,
                          0.5 * f + 2 * f * f - 1.5 * f * f * f, -0.5 * f * f + 0.5 * f * f * f};
  if (k == 0) return {0, {w[1] + 2 * w[0], w[2] - w[0], w[3], 0}};
  if (k == count - 2) return {k - 1, {w[0], w[1] - w[3], w[2] + 2 * w[3], 0}};
  return {k - 1, w};
}

double ToneSpline::at(double x, std::span<const double> values) const {
  const Weights w = weights(x, values.size());
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (w.of[i] != 0) sum += w.of[i] * values[w.first + i];
  }
  return sum;
}

}  // namespace lumaknot::diagnosis
