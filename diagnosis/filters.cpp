#include "diagnosis/filters.h"

#include <algorithm>
#include <cmath>

namespace lumaknot::diagnosis {
namespace {

/// A picture whose pixels can be asked for anywhere; beyond its edge they are the edge's.
struct Picture {
  const Drawn& drawn;
  int width, height;

  std::size_t index(int x, int y) const {
    return std::size_t(std::clamp(y, 0, height - 1)) * std::size_t(width) +
           std::size_t(std::clamp(x, 0, width - 1));
  }
  void add(Drawn& to, std::size_t i, int x, int y, double weight) const {
    to.colors[i] = to.colors[i] + drawn.colors[index(x, y)] * weight;
    to.coverage[i] += drawn.coverage[index(x, y)] * weight;
  }
};

Drawn empty(std::size_t size) { return {std::vector<Vec3d>(size), std::vector<double>(size)}; }

Drawn resampled(const Drawn& all, const PixelGrid& size, const Placement& p) {
  const Picture picture{all, size.width, size.height};
  Drawn result = empty(size.size());
  for (std::size_t i = 0; i < size.size(); ++i) {
    const double cx = 0.5 * size.width, cy = 0.5 * size.height;
    const double x = (size.x(i) + 0.5 - p.shift_x - cx) / p.scale_x + cx - 0.5;
    const double y = (size.y(i) + 0.5 - p.shift_y - cy) / p.scale_y + cy - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    picture.add(result, i, x0, y0, (1 - fx) * (1 - fy));
    picture.add(result, i, x0 + 1, y0, fx * (1 - fy));
    picture.add(result, i, x0, y0 + 1, (1 - fx) * fy);
    picture.add(result, i, x0 + 1, y0 + 1, fx * fy);
  }
  return result;
}

/// Along x, or along y.
Drawn blurred(const Drawn& all, const PixelGrid& size, double sigma, bool along_y) {
  const Picture picture{all, size.width, size.height};
  const int radius = int(std::ceil(4 * sigma));
  std::vector<double> weights;
  double sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    weights.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    sum += weights.back();
  }
  Drawn result = empty(size.size());
  for (std::size_t i = 0; i < size.size(); ++i) {
    for (std::size_t w = 0; w < weights.size(); ++w) {
      const int k = int(w) - radius;
      const int x = size.x(i) + (along_y ? 0 : k), y = size.y(i) + (along_y ? k : 0);
      picture.add(result, i, x, y, weights[w] / sum);
    }
  }
  return result;
}

Drawn median(const Drawn& all, const PixelGrid& size, int radius) {
  const Picture picture{all, size.width, size.height};
  Drawn result = empty(size.size());
  std::array<std::vector<double>, 4> values;
  for (std::size_t i = 0; i < size.size(); ++i) {
    for (auto& channel : values) channel.clear();
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const std::size_t j = picture.index(size.x(i) + dx, size.y(i) + dy);
        values[0].push_back(all.colors[j].x);
        values[1].push_back(all.colors[j].y);
        values[2].push_back(all.colors[j].z);
        values[3].push_back(all.coverage[j]);
      }
    }
    const auto middle = [](std::vector<double>& v) {
      const auto at = v.begin() + std::ptrdiff_t(v.size() / 2);
      std::ranges::nth_element(v, at);
      return *at;
    };
    result.colors[i] = {middle(values[0]), middle(values[1]), middle(values[2])};
    result.coverage[i] = middle(values[3]);
  }
  return result;
}

}  // namespace

Drawn filtered(Drawn all, const PixelGrid& all_pixels, const PictureUse& picture,
               const PixelGrid& grid) {
  if (picture.resampled) all = resampled(all, all_pixels, picture.placement);
  if (picture.blur > 0) {
    all = blurred(blurred(all, all_pixels, picture.blur, false), all_pixels, picture.blur, true);
  }
  if (picture.median > 0) all = median(all, all_pixels, picture.median);
  Drawn result = empty(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::size_t j = std::size_t(grid.y(i)) * std::size_t(grid.width) + std::size_t(grid.x(i));
    result.colors[i] = all.colors[j];
    result.coverage[i] = all.coverage[j];
  }
  return result;
}

}  // namespace lumaknot::diagnosis
