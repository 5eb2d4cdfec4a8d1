#include "validate/self_test/picture_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "diagnosis/tone.h"

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

/// Each pixel taken from elsewhere: from(x, y, width, height) is the place, or one outside.
template <class F>
std::function<Image(const Image&)> of_places(F from) {
  return [from](const Image& image) {
    Image result(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto [sx, sy] = from(x, y, image.width, image.height);
        if (sx < 0 || sy < 0 || sx >= image.width || sy >= image.height) continue;
        result.at(x, y) = image.at(sx, sy);
      }
    }
    return result;
  };
}

double raised(double x, double exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

Image blurred(const Image& image, double sigma) {
  Image result = image;
  const int radius = int(std::ceil(4 * sigma));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Vec3d color;
      double coverage = 0, sum = 0;
      for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
          const RgbaPixel& p = image.at(std::clamp(x + dx, 0, image.width - 1),
                                        std::clamp(y + dy, 0, image.height - 1));
          const double weight = std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
          color = color + to_vec(p.color) * weight;
          coverage += weight * double(p.coverage);
          sum += weight;
        }
      }
      result.at(x, y) = {to_rgb(color / sum), float(coverage / sum)};
    }
  }
  return result;
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

void add_color_faults(std::vector<Fault>& all) {
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

void add_place_faults(std::vector<Fault>& all) {
  struct Pixel {
    int x, y;
  };
  all.push_back(
      {.what = "left and right exchanged",
       .names = {"mirror-x"},
       .picture = of_places([](int x, int y, int w, int) { return Pixel{w - 1 - x, y}; })});
  all.push_back(
      {.what = "top and bottom exchanged",
       .names = {"mirror-y"},
       .picture = of_places([](int x, int y, int, int h) { return Pixel{x, h - 1 - y}; })});
  all.push_back({.what = "turned by 180 degrees",
                 .names = {"rotated-180", "camera-roll"},
                 .picture = of_places(
                     [](int x, int y, int w, int h) { return Pixel{w - 1 - x, h - 1 - y}; })});
  for (const int by : {1, 3}) {
    all.push_back(
        {.what = "moved by whole pixels",
         .names = {"shift", "shift-resampled"},
         .numbers = {{"x", double(by)}, {"y", 0}},
         .picture = of_places([by](int x, int y, int, int) { return Pixel{x - by, y}; })});
  }
  all.push_back({.what = "moved by part of a pixel, resampled",
                 .names = {"shift-resampled"},
                 .numbers = {{"x", 0.5}, {"y", 0}},
                 .picture = [](const Image& image) {
                   Image result = image;
                   for (int y = 0; y < image.height; ++y) {
                     for (int x = 1; x < image.width; ++x) {
                       const RgbaPixel &a = image.at(x - 1, y), &b = image.at(x, y);
                       result.at(x, y) = {to_rgb((to_vec(a.color) + to_vec(b.color)) * 0.5),
                                          (a.coverage + b.coverage) / 2};
                     }
                   }
                   return result;
                 }});
  for (const double sigma : {0.7, 1.5}) {
    all.push_back({.what = "blurred",
                   .names = {"blur"},
                   .numbers = {{"sigma", sigma}},
                   .picture = [sigma](const Image& image) { return blurred(image, sigma); }});
  }
}

/// Colours changed by where they are: x and y from the picture's centre, in halves of its height.
template <class F>
std::function<Image(const Image&)> by_place(F change) {
  return [change](const Image& image) {
    Image result = image;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        RgbaPixel& p = result.at(x, y);
        if (p.coverage <= 0) continue;
        p.color = to_rgb(change(to_vec(p.color), (2 * x + 1.0 - image.width) / image.height,
                                (2 * y + 1.0 - image.height) / image.height));
      }
    }
    return result;
  };
}

/// What no cause describes.
void add_foreign_faults(std::vector<Fault>& all) {
  all.push_back({.what = "vignetting", .picture = by_place([](Vec3d c, double x, double y) {
                                         return c / std::pow(1 + 0.3 * (x * x + y * y), 2);
                                       })});
  all.push_back({.what = "a gradient from left to right",
                 .picture = by_place([](Vec3d c, double x, double) { return c * (1 + 0.2 * x); })});
  all.push_back({.what = "sharpened", .picture = [](const Image& image) {
                   Image result = blurred(image, 1);
                   for (std::size_t i = 0; i < result.pixels.size(); ++i) {
                     RgbaPixel& p = result.pixels[i];
                     p.color = to_rgb(to_vec(image.pixels[i].color) * 1.8 - to_vec(p.color) * 0.8);
                     p.coverage = image.pixels[i].coverage;
                   }
                   return result;
                 }});
  all.push_back({.what = "every other line darker", .picture = [](const Image& image) {
                   Image result = image;
                   for (std::size_t i = 0; i < result.pixels.size(); ++i) {
                     if (i / std::size_t(image.width) % 2 == 0) continue;
                     result.pixels[i].color = to_rgb(to_vec(result.pixels[i].color) * 0.9);
                   }
                   return result;
                 }});
}

}  // namespace

std::vector<Fault> picture_faults() {
  std::vector<Fault> all;
  add_color_faults(all);
  add_place_faults(all);
  add_foreign_faults(all);
  return all;
}

TriangleMesh with_flat_normals(const TriangleMesh& mesh) {
  TriangleMesh flat;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                               mesh.positions[t[2]] - mesh.positions[t[0]]);
    const auto first = std::uint32_t(flat.positions.size());
    for (const std::uint32_t v : t) {
      flat.positions.push_back(mesh.positions[v]);
      flat.normals.push_back(length(normal) > 0 ? normalize(normal) : mesh.normals[v]);
      flat.uvs.push_back(mesh.uvs[v]);
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  return flat;
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
