#include "render/exact/truth.h"

#include <oneapi/tbb/parallel_for.h>

#include <mutex>

#include "render/exact/pixels.h"

namespace lumaknot::exact {
namespace {

std::vector<PixelTruth> point_row(const ExactPixels& pixels, int y, int width) {
  std::vector<PixelTruth> row;
  for (int x = 0; x < width; ++x) {
    const ExactFragment seen = pixels.at(x + 0.5, y + 0.5);
    row.push_back({pixels.sample(seen.fragment), seen.decided ? 0.0 : 1.0});
  }
  return row;
}

}  // namespace

Material exact_material(const Material& material) {
  Material exact = material;
  exact.rate = ShadingFrequency::kPixel;
  return exact;
}

Grid<ExactFragment> exact_fragments(const Scene& scene, const KnotSpec& knot) {
  const ExactPixels pixels(scene, knot);
  Grid<ExactFragment> seen(scene.view.image.width, scene.view.image.height);
  oneapi::tbb::parallel_for(0, seen.height, [&](int y) {
    for (int x = 0; x < seen.width; ++x) seen.at(x, y) = pixels.at(x + 0.5, y + 0.5);
  });
  return seen;
}

Truth draw_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options,
                 const Progress& progress) {
  const ExactPixels pixels(scene, knot);
  const int width = scene.view.image.width, height = scene.view.image.height;
  const bool area = options.sampling == TruthSampling::kArea;
  Truth truth{Image(width, height), Grid<float>(width, height)};
  std::mutex reporting;
  int finished = 0;
  oneapi::tbb::parallel_for(0, height, [&](int y) {
    const std::vector<PixelTruth> row =
        area ? area_row(pixels, y, width, options.tolerance) : point_row(pixels, y, width);
    for (int x = 0; x < width; ++x) {
      const auto& [sample, error] = row[std::size_t(x)];
      truth.image.at(x, y) = {to_rgb(sample.color), float(sample.coverage)};
      truth.error.at(x, y) = float(error);
    }
    if (!progress) return;
    const std::lock_guard lock(reporting);
    progress(double(++finished) / height);
  });
  return truth;
}

Image render_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options,
                   const Progress& progress) {
  return draw_truth(scene, knot, options, progress).image;
}

}  // namespace lumaknot::exact
