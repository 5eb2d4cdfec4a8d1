#include "render/reference.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

#include "render/shading.h"
#include "shaders/formulas/lighting.h"
#include "shaders/graph/half.h"

namespace lumaknot {
namespace {

constexpr int kBandHeight = 16;  // rows of pixels handed to a thread at once

/// Averages each n x n block of shaded fragments into rows of `image` from `row` on.
template <class S>
void resolve(const ShadingIn<S>& shading, int n, const Grid<Fragment>& band, int row,
             Image& image) {
  for (int y = 0; y < band.height / n; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Vec3d sum;
      int covered = 0;
      for (int s = 0; s < n * n; ++s) {
        const Fragment& fragment = band.at(x * n + s % n, y * n + s / n);
        sum = sum + shading.color(fragment);
        covered += fragment.covered();
      }
      const double samples = double(n) * n;
      image.at(x, row + y) = {to_rgb(sum / samples), float(covered / samples)};
    }
  }
}

/// The scene, shaded in the number type S.
template <class S>
Image render_in(const Scene& scene, const Progress& progress) {
  const ImageSpec& spec = scene.view.image;
  const int n = spec.samples;
  const int rows = std::max(1, kBandHeight / n);  // of pixels per band
  const Rasterizer rasterizer(scene.mesh, scene.view.camera, spec.width * n, spec.height * n,
                              rows * n);
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  const ShadingIn<S> shading(scene, shot);
  Image image(spec.width, spec.height);
  std::mutex reporting;
  int finished = 0;
  oneapi::tbb::parallel_for(0, rasterizer.bands(), [&](int b) {
    resolve(shading, n, rasterizer.band(b), b * rows, image);
    if (!progress) return;
    const std::lock_guard lock(reporting);
    progress(double(++finished) / rasterizer.bands());
  });
  return image;
}

}  // namespace

Vec3d shade(const Scene& scene, const Shot& shot, const Fragment& fragment) {
  return Shading(scene, shot).color(fragment);
}

Grid<Fragment> visible_fragments(const Scene& scene) {
  const ImageSpec& image = scene.view.image;
  const Rasterizer rasterizer(scene.mesh, scene.view.camera, image.width, image.height,
                              kBandHeight);
  Grid<Fragment> all(image.width, image.height);
  oneapi::tbb::parallel_for(0, rasterizer.bands(), [&](int b) {
    const Grid<Fragment> band = rasterizer.band(b);
    std::ranges::copy(band.pixels, &all.at(0, b * kBandHeight));
  });
  return all;
}

Image shade_all(const Scene& scene, const Shot& shot, const Grid<Fragment>& fragments) {
  const Shading shading(scene, shot);
  Image image(fragments.width, fragments.height);
  oneapi::tbb::parallel_for(std::size_t{0}, fragments.pixels.size(), [&](std::size_t i) {
    const Fragment& fragment = fragments.pixels[i];
    image.pixels[i] = {to_rgb(shading.color(fragment)), fragment.covered() ? 1.0f : 0.0f};
  });
  return image;
}

Image compose(const Scene& scene, const Shot& shot, const Image& texture, const Image& diffuse,
              const Image& specular) {
  const Lighting<double> lighting = lighting_of<double>(scene.view, shot.material);
  Image image(texture.width, texture.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float coverage = texture.pixels[i].coverage;
    if (coverage == 0) continue;
    const Terms<double> terms{to_vec(diffuse.pixels[i].color), to_vec(specular.pixels[i].color)};
    const Vec3d value = texture_value(to_vec(texture.pixels[i].color), shot.material);
    image.pixels[i] = {to_rgb(stage_color(value, terms, lighting, shot)), coverage};
  }
  return image;
}

Image render(const Scene& scene, const Progress& progress) {
  return render_in<double>(scene, progress);
}

Image render_in_half(const Scene& scene, const Progress& progress) {
  return render_in<Half>(scene, progress);
}

}  // namespace lumaknot
