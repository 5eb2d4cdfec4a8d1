/// Faults of the colours of finished pictures.
#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/tone.h"
#include "validate/self_test/picture_faults.h"
#include "validate/self_test/planting.h"

namespace lumaknot::validate {
namespace {

/// Each covered pixel's colour changed.
template <class F>
std::function<Image(const Image&)> of_colors(F change) {
  return [change](const Image& image) {
    Image result = image;
    for (RgbaPixel& p : result.pixels) {
      if (p.coverage > 0) p.color = to_rgb(change(to_vec(p.color)));
    }
    return result;
  };
}

template <class F>
std::function<Image(const Image&)> of_channels(F change) {
  return of_colors(
      [change](const Vec3d& c) { return Vec3d{change(c.x), change(c.y), change(c.z)}; });
}

double raised(double x, double exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

/// Gaussian noise on what is covered.
Image noisy(const Image& image, double deviation) {
  Image result = image;
  std::mt19937 random(1);
  // Twelve uniform numbers: the same on every machine, as distributions of the library are not.
  const auto normal = [&] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += double(random()) / 4294967296.0;
    return deviation * sum;
  };
  for (RgbaPixel& p : result.pixels) {
    const Vec3d more{normal(), normal(), normal()};
    if (p.coverage > 0) p.color = to_rgb(to_vec(p.color) + more);
  }
  return result;
}

}  // namespace

void add_color_faults(Faults& all) {
  for (const double gamma : {2.2, 1.8, 0.4545}) {
    all.push_back({.what = "gamma",
                   .names = {"gamma"},
                   .numbers = {{"gamma", gamma}},
                   .picture = of_channels([gamma](double x) { return raised(x, 1 / gamma); })});
  }
  all.push_back({.what = "encoded as sRGB",
                 .names = {"srgb-encoded", "srgb-encoded-straight"},
                 .picture = of_colors(encoded_srgb)});
  all.push_back({.what = "decoded from sRGB",
                 .names = {"srgb-decoded", "srgb-decoded-straight"},
                 .picture = of_colors(decoded_srgb)});
  for (const double gain : {0.5, 0.98, 1.05}) {
    all.push_back({.what = "exposure",
                   .names = {"exposure", "all-light"},
                   .numbers = {{"gain", gain}},
                   .picture = of_channels([gain](double x) { return gain * x; })});
  }
  all.push_back({.what = "offset",
                 .names = {"offset", "emissive", "luma-offset"},
                 .numbers = {{"offset", 0.05}},
                 .picture = of_channels([](double x) { return x + 0.05; })});
  all.push_back({.what = "contrast",
                 .names = {"contrast"},
                 .numbers = {{"contrast", 1.2}},
                 .picture = of_channels([](double x) { return 0.5 + 1.2 * (x - 0.5); })});
  all.push_back(
      {.what = "white balance",
       .names = {"white-balance"},
       .numbers = {{"r", 1.1}, {"g", 1}, {"b", 0.9}},
       .picture = of_colors([](const Vec3d& c) { return Vec3d{1.1 * c.x, c.y, 0.9 * c.z}; })});
  const auto saturation = [](double s) {
    return of_colors([s](const Vec3d& c) {
      const double y = 0.29889531 * c.x + 0.58662247 * c.y + 0.11448223 * c.z;
      return Vec3d{y, y, y} + (c - Vec3d{y, y, y}) * s;
    });
  };
  all.push_back({.what = "saturation",
                 .names = {"saturation"},
                 .numbers = {{"saturation", 0.7}},
                 .picture = saturation(0.7)});
  all.push_back({.what = "grey", .names = {"grey", "saturation"}, .picture = saturation(0)});
  all.push_back({.what = "negative", .names = {"negative"}, .picture = of_channels([](double x) {
                                                              return 1 - x;
                                                            })});
  all.push_back({.what = "red and blue exchanged",
                 .names = {"channels-bgr", "texture-channels-bgr"},
                 .picture = of_colors([](const Vec3d& c) { return Vec3d{c.z, c.y, c.x}; })});
  all.push_back({.what = "channels rotated",
                 .names = {"channels-gbr", "texture-channels-gbr"},
                 .picture = of_colors([](const Vec3d& c) { return Vec3d{c.y, c.z, c.x}; })});
  all.push_back({.what = "Reinhard's curve",
                 .names = {"tone-reinhard"},
                 .picture = of_channels([](double x) { return x / (1 + std::max(x, 0.0)); })});
  struct Curve {
    std::string id;
    diagnosis::Tone tone;
  };
  for (const Curve& curve :
       {Curve{"aces", diagnosis::Tone::kAces}, Curve{"aces-fitted", diagnosis::Tone::kAcesFitted},
        Curve{"hable", diagnosis::Tone::kHable}, Curve{"neutral", diagnosis::Tone::kNeutral},
        Curve{"agx", diagnosis::Tone::kAgx}, Curve{"cineon", diagnosis::Tone::kCineon}}) {
    all.push_back({.what = "the tone curve " + curve.id,
                   .names = {"tone-" + curve.id},
                   .picture = of_colors(
                       [tone = curve.tone](const Vec3d& c) { return diagnosis::toned(tone, c); })});
  }
  all.push_back({.what = "a tone curve that has no name",
                 .names = {"tone-curve"},
                 .picture = of_channels([](double x) {
                   const double stops = std::log2(std::max(x, 0.0) / 0.18 + 0.02);
                   return 1 / (1 + std::exp(-0.9 * stops));
                 })});
  all.push_back({.what = "colours in Rec. 2020",
                 .names = {"primaries-rec2020"},
                 .picture = of_colors([](const Vec3d& c) {
                   // ITU-R BT.2087-0, table 4.
                   return Vec3d{dot(Vec3d{0.6274, 0.3293, 0.0433}, c),
                                dot(Vec3d{0.0691, 0.9195, 0.0114}, c),
                                dot(Vec3d{0.0164, 0.0880, 0.8956}, c)};
                 })});
  for (const double deviation : {0.02, 0.1}) {
    all.push_back({.what = "noise", .names = {"noise"}, .picture = [deviation](const Image& image) {
                     return noisy(image, deviation);
                   }});
  }
  for (const int bits : {4, 5, 6}) {
    const double steps = (1 << bits) - 1;
    all.push_back({.what = std::to_string(bits) + " bits",
                   .names = {"bits-" + std::to_string(bits)},
                   .picture = of_channels([steps](double x) {
                     return std::round(std::clamp(x, 0.0, 1.0) * steps) / steps;
                   })});
  }
}

Vec3d encoded_srgb(const Vec3d& linear) {
  const auto encode = [](double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  };
  return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

Vec3d decoded_srgb(const Vec3d& encoded) {
  const auto decode = [](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return {decode(encoded.x), decode(encoded.y), decode(encoded.z)};
}

}  // namespace lumaknot::validate
