#include "validate/compare/flip.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "math/angle.h"

namespace lumaknot::validate {
namespace {

using Plane = Grid<float>;
using Kernel = std::vector<float>;  // of odd length, its middle at the pixel

/// exp(-x^2 / (2 sigma^2)) for |x| <= radius, its sum one.
Kernel gaussian(double sigma, int radius) {
  Kernel kernel;
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) sum += std::exp(-x * x / (2 * sigma * sigma));
  for (int x = -radius; x <= radius; ++x) {
    kernel.push_back(float(std::exp(-x * x / (2 * sigma * sigma)) / sum));
  }
  return kernel;
}

/// Positive weights divided by their sum, negative ones by theirs.
void balance(Kernel& kernel) {
  double above = 0, below = 0;
  for (const float w : kernel) (w > 0 ? above : below) += std::abs(double(w));
  for (float& w : kernel) w = float(w / (w > 0 ? above : below));
}

/// First and second derivative of a Gaussian: detectors of edges and of points.
Kernel edge_detector(double sigma, int radius) {
  Kernel kernel = gaussian(sigma, radius);
  for (std::size_t i = 0; i < kernel.size(); ++i) kernel[i] *= float(radius - int(i));
  balance(kernel);
  return kernel;
}

Kernel point_detector(double sigma, int radius) {
  Kernel kernel = gaussian(sigma, radius);
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    const int x = int(i) - radius;
    kernel[i] *= float(x * x / (sigma * sigma) - 1);
  }
  balance(kernel);
  return kernel;
}

template <class F>
void each_row(const Plane& plane, F work) {
  oneapi::tbb::parallel_for(0, plane.height, work);
}

/// Borders repeat the outermost pixel.
Plane along_rows(const Plane& plane, const Kernel& kernel) {
  const int radius = int(kernel.size()) / 2, width = plane.width;
  Plane result(width, plane.height);
  each_row(plane, [&](int y) {
    std::vector<float> row(std::size_t(width + 2 * radius));
    for (int x = 0; x < int(row.size()); ++x) {
      row[std::size_t(x)] = plane.at(std::clamp(x - radius, 0, width - 1), y);
    }
    float* sums = &result.at(0, y);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      for (int x = 0; x < width; ++x) sums[x] += kernel[k] * row[std::size_t(x) + k];
    }
  });
  return result;
}

Plane along_columns(const Plane& plane, const Kernel& kernel) {
  const int radius = int(kernel.size()) / 2, width = plane.width;
  Plane result(width, plane.height);
  each_row(plane, [&](int y) {
    float* sums = &result.at(0, y);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const int from = std::clamp(y + int(k) - radius, 0, plane.height - 1);
      const float* row = &plane.at(0, from);
      for (int x = 0; x < width; ++x) sums[x] += kernel[k] * row[x];
    }
  });
  return result;
}

Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
  return along_columns(along_rows(plane, across), down);
}

/// One Gaussian of a contrast sensitivity in space: a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees
/// (the paper's table 1).
struct ContrastSensitivity {
  double a, b;
};
constexpr ContrastSensitivity kLuma{1, 0.0047}, kRedGreen{1, 0.0053};
constexpr ContrastSensitivity kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidest = 0.04;  // the largest b: all filters have its radius

int eye_radius(double ppd) {
  return int(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * ppd));
}

Kernel eye_kernel(const ContrastSensitivity& s, double ppd) {
  return gaussian(std::sqrt(s.b / (2 * kPi * kPi)) * ppd, eye_radius(ppd));
}

/// The weight of a Gaussian among several, the kernels of which have a sum of one.
double share_of(const ContrastSensitivity& s, double ppd) {
  double sum = 0;
  const int radius = eye_radius(ppd);
  for (int x = -radius; x <= radius; ++x) {
    sum += std::exp(-kPi * kPi * x * x / (ppd * ppd * s.b));
  }
  return s.a * std::sqrt(kPi / s.b) * sum * sum;
}

/// The opponent space YCxCz, in which filters are linear: L*a*b* without its cube root.
struct Opponent {
  Plane y, cx, cz;
};

Vec3<float> relative_xyz(const Rgb& c) {
  const auto limited = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
  const Vec3<float> xyz = xyz_from_rgb<float>({limited(c.r), limited(c.g), limited(c.b)});
  return {xyz.x / float(kWhiteXyz.x), xyz.y, xyz.z / float(kWhiteXyz.z)};
}

Opponent opponent(const Image& image) {
  Opponent result{
      {image.width, image.height}, {image.width, image.height}, {image.width, image.height}};
  each_row(result.y, [&](int row) {
    Rgb last;
    Vec3<float> xyz = relative_xyz(last);  // cached, since backgrounds are one colour
    for (int x = 0; x < image.width; ++x) {
      const Rgb& color = image.at(x, row).color;
      if (!(color == last)) xyz = relative_xyz(last = color);
      result.y.at(x, row) = 116 * xyz.y - 16;
      result.cx.at(x, row) = 500 * (xyz.x - xyz.y);
      result.cz.at(x, row) = 200 * (xyz.y - xyz.z);
    }
  });
  return result;
}

Opponent as_the_eye_resolves(const Opponent& image, double ppd) {
  const Kernel luma = eye_kernel(kLuma, ppd), red_green = eye_kernel(kRedGreen, ppd);
  const Kernel wide = eye_kernel(kBlueYellow[0], ppd), narrow = eye_kernel(kBlueYellow[1], ppd);
  const double first = share_of(kBlueYellow[0], ppd), second = share_of(kBlueYellow[1], ppd);
  const float share = float(first / (first + second));
  Opponent result{filtered(image.y, luma, luma), filtered(image.cx, red_green, red_green),
                  filtered(image.cz, wide, wide)};
  const Plane other = filtered(image.cz, narrow, narrow);
  for (std::size_t i = 0; i < other.pixels.size(); ++i) {
    float& cz = result.cz.pixels[i];
    cz = share * cz + (1 - share) * other.pixels[i];
  }
  return result;
}

/// L*a*b* of linear light, its chroma weighted by its lightness (Hunt's effect).
Lab<float> hunt_adjusted(const Vec3<float>& linear) {
  const auto limited = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
  const Lab<float> lab = lab_from_xyz<float>(transform<float>(
      kXyzFromLinear, Vec3<float>{limited(linear.x), limited(linear.y), limited(linear.z)}));
  return {lab.lightness, 0.01f * lab.lightness * lab.a, 0.01f * lab.lightness * lab.b};
}

Lab<float> perceived(float y, float cx, float cz) {
  const float luminance = (y + 16) / 116;
  const Vec3<float> xyz{(cx / 500 + luminance) * float(kWhiteXyz.x), luminance,
                        (luminance - cz / 200) * float(kWhiteXyz.z)};
  return hunt_adjusted(transform<float>(kLinearFromXyz, xyz));
}

Grid<Lab<float>> perceived(const Opponent& eye) {
  Grid<Lab<float>> colors(eye.y.width, eye.y.height);
  each_row(eye.y, [&](int y) {
    for (int x = 0; x < colors.width; ++x) {
      colors.at(x, y) = perceived(eye.y.at(x, y), eye.cx.at(x, y), eye.cz.at(x, y));
    }
  });
  return colors;
}

/// The length of a detector's responses in x and y.
Plane strength(const Plane& luma, const Kernel& detector, const Kernel& smooth) {
  Plane result = filtered(luma, detector, smooth);
  const Plane down = filtered(luma, smooth, detector);
  for (std::size_t i = 0; i < down.pixels.size(); ++i) {
    result.pixels[i] = std::hypot(result.pixels[i], down.pixels[i]);
  }
  return result;
}

double feature_sigma(double ppd) {
  constexpr double kFeature = 0.082;  // degrees
  return 0.5 * kFeature * ppd;
}

int feature_radius(double ppd) { return int(std::ceil(3 * feature_sigma(ppd))); }

constexpr float kColorExponent = 0.7f;  // q_c
constexpr float kKnee = 0.4f, kAtKnee = 0.95f;

/// HyAB: the city-block distance of lightness and chroma.
float color_difference(const Lab<float>& p, const Lab<float>& q) {
  return std::pow(std::abs(p.lightness - q.lightness) + std::hypot(p.a - q.a, p.b - q.b),
                  kColorExponent);
}

/// Differences up to a part of the largest, that of green and blue, take most of [0, 1].
float compressed(float difference) {
  static const float kLargest =
      color_difference(hunt_adjusted({0, 1, 0}), hunt_adjusted({0, 0, 1}));
  const float knee = kKnee * kLargest;
  if (difference < knee) return kAtKnee / knee * difference;
  return kAtKnee + (difference - knee) / (kLargest - knee) * (1 - kAtKnee);
}

/// Pixels of an image, right and bottom excluded.
struct Box {
  int left, top, right, bottom;
};

bool differs(const Image& a, const Image& b, const Box& box, float from) {
  const auto far = [from](float p, float q) {
    return std::abs(std::clamp(p, 0.0f, 1.0f) - std::clamp(q, 0.0f, 1.0f)) >= from;
  };
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Rgb &p = a.at(x, y).color, &q = b.at(x, y).color;
      if (far(p.r, q.r) || far(p.g, q.g) || far(p.b, q.b)) return true;
    }
  }
  return false;
}

/// A part of an image, and what its FLIP depends on.
struct Tile {
  Box box, seen;
};

std::vector<Tile> tiles_of(int width, int height) {
  constexpr int kSide = 128;
  const int reach =
      std::max(eye_radius(kFlipPixelsPerDegree), feature_radius(kFlipPixelsPerDegree));
  std::vector<Tile> tiles;
  for (int y = 0; y < height; y += kSide) {
    for (int x = 0; x < width; x += kSide) {
      const Box box{x, y, std::min(x + kSide, width), std::min(y + kSide, height)};
      tiles.push_back({box,
                       {std::max(box.left - reach, 0), std::max(box.top - reach, 0),
                        std::min(box.right + reach, width), std::min(box.bottom + reach, height)}});
    }
  }
  return tiles;
}

Image part(const Image& image, const Box& box) {
  Image result(box.right - box.left, box.bottom - box.top);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      result.at(x, y) = image.at(box.left + x, box.top + y);
    }
  }
  return result;
}

}  // namespace

FlipImage flip_image(const Image& image, double pixels_per_degree) {
  const double sigma = feature_sigma(pixels_per_degree);
  const int radius = feature_radius(pixels_per_degree);
  const Opponent opponents = opponent(image);
  Plane luma = opponents.y;
  for (float& y : luma.pixels) y = (y + 16) / 116;
  const Kernel smooth = gaussian(sigma, radius);
  return {perceived(as_the_eye_resolves(opponents, pixels_per_degree)),
          strength(luma, edge_detector(sigma, radius), smooth),
          strength(luma, point_detector(sigma, radius), smooth), pixels_per_degree};
}

Grid<float> flip_errors(const FlipImage& reference, const FlipImage& test) {
  assert(reference.edges.pixels.size() == test.edges.pixels.size());
  assert(reference.pixels_per_degree == test.pixels_per_degree);
  Grid<float> errors(reference.edges.width, reference.edges.height);
  each_row(errors, [&](int y) {
    for (int x = 0; x < errors.width; ++x) {
      const float color =
          compressed(color_difference(reference.colors.at(x, y), test.colors.at(x, y)));
      const float feature = std::max(std::abs(reference.edges.at(x, y) - test.edges.at(x, y)),
                                     std::abs(reference.points.at(x, y) - test.points.at(x, y)));
      const float exponent = std::sqrt(feature * float(std::numbers::sqrt2 / 2));  // q_f = 1/2
      errors.at(x, y) = std::pow(color, 1 - exponent);
    }
  });
  return errors;
}

Grid<float> flip_errors_near(const Image& reference, const Image& test, float from) {
  const int width = reference.width, height = reference.height;
  const std::vector<Tile> tiles = tiles_of(width, height);
  std::vector<Tile> wanted;
  std::ranges::copy_if(tiles, std::back_inserter(wanted),
                       [&](const Tile& tile) { return differs(reference, test, tile.seen, from); });
  if (2 * wanted.size() > tiles.size()) return flip_errors(flip_image(reference), flip_image(test));
  Grid<float> errors(width, height);
  for (const auto& [tile, seen] : wanted) {
    const Grid<float> found =
        flip_errors(flip_image(part(reference, seen)), flip_image(part(test, seen)));
    for (int y = tile.top; y < tile.bottom; ++y) {
      for (int x = tile.left; x < tile.right; ++x) {
        errors.at(x, y) = found.at(x - seen.left, y - seen.top);
      }
    }
  }
  return errors;
}

double mean_flip(const FlipImage& reference, const FlipImage& test) {
  double sum = 0;
  const Grid<float> errors = flip_errors(reference, test);
  for (const float e : errors.pixels) sum += double(e);
  return sum / double(errors.pixels.size());
}

}  // namespace lumaknot::validate
