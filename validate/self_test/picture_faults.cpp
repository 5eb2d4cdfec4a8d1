#include "validate/self_test/picture_faults.h"

#include <algorithm>
#include <cmath>

#include "render/triangle.h"
#include "validate/self_test/planting.h"

namespace lumaknot::validate {
namespace {

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

}  // namespace

void add_place_faults(Faults& all) {
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

/// What no cause describes.
void add_foreign_faults(Faults& all) {
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

TriangleMesh with_flat_normals(const TriangleMesh& mesh) {
  TriangleMesh flat;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d normal = triangle_normal(mesh, t);
    const auto first = std::uint32_t(flat.positions.size());
    for (const std::uint32_t v : t) {
      flat.positions.push_back(mesh.positions[v]);
      flat.normals.push_back(length(normal) > 0 ? normal : mesh.normals[v]);
      flat.uvs.push_back(mesh.uvs[v]);
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  return flat;
}

}  // namespace lumaknot::validate
