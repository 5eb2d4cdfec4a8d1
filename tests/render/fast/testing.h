/// Shared by the fast renderer's tests: scenes, and its pictures compared with the reference's.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshgen/knot_mesh.h"
#include "render/fast/renderer.h"
#include "render/reference.h"
#include "scene/presets.h"
#include "tests/render/testing.h"

namespace lumaknot::testing {

/// A texture whose neighbours differ, with values that are bytes, or not bytes with `scale` < 1.
inline TextureImage noise_texture(int width, int height, float scale = 1) {
  TextureImage image(width, height);
  std::uint32_t state = 12345;
  const auto next = [&] {
    state = state * 1664525 + 1013904223;
    return float(state >> 24) / 255 * scale;
  };
  for (Rgb& texel : image.pixels) texel = {next(), next(), next()};
  return image;
}

/// A knot of `segments` x `sides` under the default camera.
inline Scene knot_scene(int size = 96, int segments = 96, int sides = 12) {
  KnotSpec knot;
  knot.segments = segments;
  knot.sides = sides;
  Scene scene{knot_mesh(knot), noise_texture(16, 8), {}};
  scene.view.image = {size, size, 1};
  return scene;
}

inline Image fast_image(const Scene& scene, const fast::Options& options = {}) {
  Image image;
  fast::Renderer(scene, options).draw(image);
  return image;
}

inline std::vector<fast::SimdLevel> simd_levels() {
  std::vector<fast::SimdLevel> levels;
  for (const fast::SimdLevel level :
       {fast::SimdLevel::kBaseline, fast::SimdLevel::kAvx2, fast::SimdLevel::kAvx512}) {
    if (level <= fast::best_simd_level()) levels.push_back(level);
  }
  return levels;
}

/// How two pictures differ.
struct Difference {
  int coverage = 0;          ///< pixels covered in only one
  int covered = 0;           ///< covered in both
  double max = 0, mean = 0;  ///< of the largest channel's, over those
};

inline Difference difference(const Image& a, const Image& b) {
  Difference d;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const RgbaPixel &p = a.pixels[i], &q = b.pixels[i];
    d.coverage += (p.coverage > 0) != (q.coverage > 0);
    if (!(p.coverage > 0) || !(q.coverage > 0)) continue;
    ++d.covered;
    const double error = std::max({std::abs(p.color.r - q.color.r), std::abs(p.color.g - q.color.g),
                                   std::abs(p.color.b - q.color.b)});
    d.max = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(d.max, error);
    d.mean += error;
  }
  d.mean /= std::max(1, d.covered);
  return d;
}

}  // namespace lumaknot::testing
