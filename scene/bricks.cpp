#include "scene/bricks.h"

#include <algorithm>
#include <cmath>

namespace lumaknot {
namespace {

constexpr int kSize = 512;
constexpr int kRows = 8, kBricksPerRow = 4;
constexpr double kMortar = 5;  // texels from a brick's edge to the joint's middle

/// A fixed pseudo-random number in [0, 1) for a lattice point (a finaliser of the murmur kind).
double noise(unsigned x, unsigned y) {
  unsigned h = x * 0x9E3779B1u + y * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return (h ^ (h >> 15)) / 4294967296.0;
}

/// Noise on a lattice `cell` texels wide, linear between its points, repeating at the edges.
double smooth_noise(int x, int y, int cell, unsigned seed) {
  const int n = kSize / cell, cx = x / cell, cy = y / cell;
  const double fx = double(x % cell) / cell, fy = double(y % cell) / cell;
  const auto at = [&](int i, int j) {
    return noise(unsigned(i % n) + seed * 977u, unsigned(j % n));
  };
  return (at(cx, cy) * (1 - fx) + at(cx + 1, cy) * fx) * (1 - fy) +
         (at(cx, cy + 1) * (1 - fx) + at(cx + 1, cy + 1) * fx) * fy;
}

/// Steps smoothly from 0 at `a` to 1 at `b`.
double smoothstep(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3d texel(int x, int y) {
  const int height = kSize / kRows, width = kSize / kBricksPerRow;
  const int row = y / height;
  const int shifted = (x + (row % 2) * width / 2) % kSize;
  const int column = shifted / width;
  const double to_side = std::min(shifted % width, width - 1 - shifted % width);
  const double to_edge = std::min(y % height, height - 1 - y % height);
  const double worn = 3 * smooth_noise(x, y, 8, 1);
  const double brick =
      smoothstep(kMortar - 2, kMortar + 1, std::min(to_side, to_edge) - worn + 1.5);
  const double grain = 0.7 * smooth_noise(x, y, 4, 2) + 0.3 * noise(unsigned(x), unsigned(y));
  const double tone = noise(unsigned(column) + 31u, unsigned(row) + 17u);
  const Vec3d clay =
      Vec3d{0.62, 0.24, 0.16} * (0.75 + 0.4 * tone) + Vec3d{1, 0.8, 0.6} * (0.12 * (grain - 0.5));
  const Vec3d mortar = Vec3d{0.74, 0.71, 0.65} * (0.85 + 0.2 * grain);
  return mortar + (clay - mortar) * brick;
}

}  // namespace

TextureImage bricks() {
  TextureImage image(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const auto eight_bit = [](double v) {
        return float(std::round(std::clamp(v, 0.0, 1.0) * 255)) / 255.0f;
      };
      const Vec3d color = texel(x, y);
      image.at(x, y) = {eight_bit(color.x), eight_bit(color.y), eight_bit(color.z)};
    }
  }
  return image;
}

}  // namespace lumaknot
