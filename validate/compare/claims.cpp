#include "validate/compare/claims.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "shaders/spaces/yiq.h"

namespace lumaknot::validate {
namespace {

double chroma(const Rgb& c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); }

Rgb displayed(const Rgb& c) { return {saturate(c.r), saturate(c.g), saturate(c.b)}; }

/// The angle between two colours' hues in the I-Q plane, degrees in [0, 180].
double hue_angle(const Rgb& a, const Rgb& b) {
  const Yiq<double> p = yiq_from_rgb<double>(to_vec(a)), q = yiq_from_rgb<double>(to_vec(b));
  return std::abs(std::atan2(p.i * q.q - p.q * q.i, p.i * q.i + p.q * q.q)) * 180 / kPi;
}

}  // namespace

Claims measure_claims(const Image& final, const Image& texture, const Image& specular) {
  constexpr double kHighlight = 0.1, kHasHue = 0.02;
  Claims claims;
  long long covered = 0, with_hue = 0, at_zero = 0, at_one = 0;
  double chroma_sum = 0, angle_sum = 0;
  for (std::size_t i = 0; i < final.pixels.size(); ++i) {
    if (final.pixels[i].coverage <= 0 || texture.pixels[i].coverage <= 0) continue;
    ++covered;
    const Rgb &raw = final.pixels[i].color, shown = displayed(raw);
    at_zero += std::min({raw.r, raw.g, raw.b}) <= 0;
    at_one += std::max({raw.r, raw.g, raw.b}) >= 1;
    if (specular.pixels[i].color.r >= kHighlight) {
      ++claims.highlight_pixels;
      chroma_sum += chroma(shown);
    }
    if (chroma(shown) >= kHasHue && chroma(texture.pixels[i].color) >= kHasHue) {
      ++with_hue;
      angle_sum += hue_angle(shown, texture.pixels[i].color);
    }
  }
  const auto share = [](double part, long long whole) { return whole ? part / double(whole) : 0; };
  claims.highlight_chroma = share(chroma_sum, claims.highlight_pixels);
  claims.hue_shift_degrees = share(angle_sum, with_hue);
  claims.clipped_at_zero = share(double(at_zero), covered);
  claims.clipped_at_one = share(double(at_one), covered);
  return claims;
}

}  // namespace lumaknot::validate
