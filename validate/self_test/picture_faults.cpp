#include "validate/self_test/picture_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

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
         .names = {"shift"},
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

}  // namespace

std::vector<Fault> picture_faults() {
  std::vector<Fault> all;
  add_color_faults(all);
  add_place_faults(all);
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
