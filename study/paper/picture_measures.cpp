#include "study/paper/picture_measures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/angle.h"
#include "shaders/spaces/cielab.h"
#include "shaders/spaces/srgb.h"
#include "shaders/spaces/yiq.h"
#include "study/measure/ciede2000.h"
#include "validate/compare/quantile.h"

namespace lumaknot::paper {
namespace {

Vec3d displayed(const RgbaPixel& pixel) { return saturate(to_vec(pixel.color)); }

Lab<double> lab_of(const RgbaPixel& pixel) {
  return lab_from_xyz<double>(xyz_from_rgb<double>(displayed(pixel)));
}

double chroma_of(const Lab<double>& lab) { return std::hypot(lab.a, lab.b); }

double luma_of(const RgbaPixel& pixel) { return yiq_from_rgb<double>(displayed(pixel)).y; }

/// The mean of value(i) over the marked pixels that have one.
template <class F>
double mean_of(const Marks& where, F value) {
  double sum = 0;
  long long count = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (!where[i]) continue;
    const std::optional<double> v = value(i);
    if (!v) continue;
    sum += *v;
    ++count;
  }
  return count ? sum / double(count) : 0;
}

/// The change of pixels whose difference is difference(i).
template <class F>
Change summed(const Marks& where, F difference) {
  Change change;
  long long count = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (!where[i]) continue;
    const double d = difference(i);
    ++count;
    change.pixels += d > kStep;
    change.mean += d;
    change.max = std::max(change.max, d);
  }
  if (count == 0) return {};
  change.mean /= double(count);
  change.share = double(change.pixels) / double(count);
  return change;
}

}  // namespace

Marks covered(const Image& image) {
  return marked(image, [](double) { return true; });
}

Marks marked(const Image& stage, const std::function<bool(double)>& is_in) {
  Marks marks(stage.pixels.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const RgbaPixel& pixel = stage.pixels[i];
    marks[i] = pixel.coverage > 0 && is_in(double(pixel.color.r)) ? 1 : 0;
  }
  return marks;
}

Marks both(const Marks& a, const Marks& b) {
  Marks marks(a.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = a[i] && b[i] ? 1 : 0;
  return marks;
}

double share_marked(const Marks& marks, const Image& image) {
  const auto all = std::ranges::count(covered(image), 1);
  return all ? double(std::ranges::count(marks, 1)) / double(all) : 0;
}

Change change_between(const Image& a, const Image& b, const Marks& where) {
  return summed(where, [&](std::size_t i) {
    return largest_magnitude(displayed(a.pixels[i]) - displayed(b.pixels[i]));
  });
}

Change change_between(const Image& a, const Image& b) { return change_between(a, b, covered(a)); }

Change unlimited_change(const Image& a, const Image& b) {
  return summed(covered(a), [&](std::size_t i) {
    return largest_magnitude(to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color));
  });
}

double largest_tint(const Image& image) {
  double tint = 0;
  for (const RgbaPixel& p : image.pixels) {
    if (p.coverage <= 0) continue;
    const auto [low, high] = std::minmax({p.color.r, p.color.g, p.color.b});
    tint = std::max(tint, double(high) - double(low));
  }
  return tint;
}

Image minus(const Image& a, const Image& b) {
  Image result = a;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    result.pixels[i].color = to_rgb(to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color));
  }
  return result;
}

double mean_chroma(const Image& image, const Marks& where) {
  return mean_of(where, [&](std::size_t i) -> std::optional<double> {
    return chroma_of(lab_of(image.pixels[i]));
  });
}

double mean_lightness(const Image& image, const Marks& where) {
  return mean_of(where, [&](std::size_t i) -> std::optional<double> {
    return lab_of(image.pixels[i]).lightness;
  });
}

double saturation(const Image& image, const Marks& where) {
  const double lightness = mean_lightness(image, where);
  return lightness > 0 ? mean_chroma(image, where) / lightness : 0;
}

double mean_hue_turn(const Image& a, const Image& b, const Marks& where) {
  constexpr double kHasHue = 2;
  return mean_of(where, [&](std::size_t i) -> std::optional<double> {
    const Lab<double> p = lab_of(a.pixels[i]), q = lab_of(b.pixels[i]);
    if (chroma_of(p) < kHasHue || chroma_of(q) < kHasHue) return std::nullopt;
    const double angle = std::atan2(p.a * q.b - p.b * q.a, p.a * q.a + p.b * q.b);
    return std::abs(angle) * 180 / kPi;
  });
}

Rise luma_rise(const Image& image, const Image& above) {
  Rise rise;
  const Marks where = covered(image);
  rise.share = mean_of(where, [&](std::size_t i) -> std::optional<double> {
    const double by = luma_of(image.pixels[i]) - luma_of(above.pixels[i]);
    rise.max = std::max(rise.max, by);
    return by > kStep ? 1.0 : 0.0;
  });
  return rise;
}

ColorDifference color_difference(const Image& a, const Image& b, const Marks& where) {
  std::vector<double> all;
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (where[i]) all.push_back(measure::ciede2000(lab_of(a.pixels[i]), lab_of(b.pixels[i])));
  }
  if (all.empty()) return {};
  double sum = 0;
  for (const double d : all) sum += d;
  return {sum / double(all.size()), validate::quantile(all, 0.95)};
}

double share_out_of_gamut(const Image& image) {
  constexpr float kRounding = 1e-6f;  // of M, W and float colours
  return mean_of(covered(image), [&](std::size_t i) -> std::optional<double> {
    const Rgb& c = image.pixels[i].color;
    const auto [low, high] = std::minmax({c.r, c.g, c.b});
    return low < -kRounding || high > 1 + kRounding ? 1.0 : 0.0;
  });
}

bool is_finite(const Image& image) {
  return std::ranges::all_of(image.pixels,
                             [](const RgbaPixel& p) { return is_finite(to_vec(p.color)); });
}

}  // namespace lumaknot::paper
