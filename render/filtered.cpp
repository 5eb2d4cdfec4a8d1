#include "render/filtered.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/angle.h"
#include "render/shading.h"
#include "system/process.h"

namespace lumaknot {
namespace {

constexpr int kGrid = 8;      // samples of a pass along a pixel's side
constexpr int kMargin = 2;    // pixels about the image that filters reach
constexpr int kBandRows = 4;  // of pixels
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What samples make of a pixel, or of a row of them.
struct PixelSums {
  std::array<double, 7> weighted{};  ///< red, green, blue, coverage, and the colour's squares
  std::array<double, 3> low{kInfinity, kInfinity, kInfinity};  ///< of covered samples
  std::array<double, 3> high{-kInfinity, -kInfinity, -kInfinity};

  void add(const PixelSums& more, double weight) {
    if (weight == 0) return;
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] += weight * more.weighted[i];
    for (std::size_t c = 0; c < low.size(); ++c) {
      low[c] = std::min(low[c], more.low[c]);
      high[c] = std::max(high[c], more.high[c]);
    }
  }
};

PixelSums sums_of(const Vec3d& c) {
  return {{c.x, c.y, c.z, 1, c.x * c.x, c.y * c.y, c.z * c.z}, {c.x, c.y, c.z}, {c.x, c.y, c.z}};
}

/// A sample's place in the cell of its grid, each coordinate in [-0.5, 0.5).
struct CellPlace {
  double x = 0, y = 0;
};

/// The i-th of `count` Hammersley points; those of the second half are moved by the golden ratio.
CellPlace cell_place(int i, int count, int half) {
  constexpr double kGolden = 0.6180339887498949;
  double reversed = 0, digit = 0.5;
  for (int rest = i; rest > 0; rest /= 2, digit /= 2) reversed += digit * (rest % 2);
  const double x = (i + 0.5) / count + half * kGolden;
  const double y = reversed + 0.5 / count + half * kGolden;
  return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

/// The pixels that a column or a row of samples adds to.
struct Footprint {
  int first = 0;                    ///< may lie outside the image
  std::array<double, 4> weights{};  ///< of it and its successors
};

/// Of each column, or of each row from the top, of the samples of `pixels` pixels and the margins,
/// shifted by `shift` samples. The weights of a pixel sum up to 1.
std::vector<Footprint> footprints(const PixelFilter& filter, int pixels, double shift,
                                  bool upwards) {
  std::vector<Footprint> all(std::size_t((pixels + 2 * kMargin) * kGrid));
  double sum = 0;  // of one pixel's: its samples lie as those of any other
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double place = (double(i) + 0.5 - shift) / kGrid - kMargin;
    all[i].first = int(std::floor(place - filter.reach - 0.5)) + 1;
    double offset = place - (all[i].first + 0.5);
    for (double& weight : all[i].weights) {
      if (std::abs(offset) < filter.reach) weight = filter.density(upwards ? -offset : offset);
      if (i < kGrid) sum += weight;
      --offset;
    }
  }
  for (Footprint& footprint : all) {
    for (double& weight : footprint.weights) weight /= sum;
  }
  return all;
}

/// The scene's camera, its image larger by the margins.
Camera with_margins(Camera camera, int height) {
  const double half = std::tan(camera.fov_degrees * kDegree / 2) * (height + 2 * kMargin) / height;
  camera.fov_degrees = 2 * std::atan(half) * kDegrees;
  return camera;
}

/// One estimate, from kGrid x kGrid samples per pixel.
class FilterPass {
 public:
  FilterPass(const Scene& scene, const Shading& shading, const PixelFilter& filter,
             const CellPlace& place)
      : shading_(shading),
        width_(scene.view.image.width),
        height_(scene.view.image.height),
        columns_(footprints(filter, width_, place.x, false)),
        rows_(footprints(filter, height_, place.y, true)),
        rasterizer_(rasterizer_of(scene, place)) {}

  Grid<PixelSums> draw() const {
    std::vector<Grid<PixelSums>> bands(std::size_t(rasterizer_.bands()));
    oneapi::tbb::parallel_for(0, rasterizer_.bands(),
                              [&](int b) { bands[std::size_t(b)] = band(b); });
    Grid<PixelSums> image(width_, height_);
    for (int b = 0; b < rasterizer_.bands(); ++b) {
      const Grid<PixelSums>& sums = bands[std::size_t(b)];
      const int first = first_row(b);
      for (int y = std::max(0, -first); y < std::min(sums.height, height_ - first); ++y) {
        add(&sums.at(0, y), 1, &image.at(0, first + y));
      }
    }
    return image;
  }

 private:
  /// The first row of pixels that a band adds to.
  static int first_row(int band) { return band * kBandRows - 2 * kMargin; }

  /// With the mesh sheared in view space, which shifts its image.
  Rasterizer rasterizer_of(const Scene& scene, const CellPlace& place) const {
    const Camera camera = with_margins(scene.view.camera, height_);
    const int width = int(columns_.size()), height = int(rows_.size());
    const Projection projection(camera, width, height);
    std::vector<Vec3d> positions;
    positions.reserve(scene.mesh.positions.size());
    for (const Vec3d& p : scene.mesh.positions) {
      const Vec3d view = projection.to_view(p);
      const double step = view.z * projection.pixel_width();
      positions.push_back(view + Vec3d{place.x * step, -place.y * step, 0});
    }
    return {scene.mesh, std::move(positions), projection, near_depth(camera), width,
            height,     kBandRows * kGrid};
  }

  /// What a band's samples add to the pixels from first_row() on.
  Grid<PixelSums> band(int index) const {
    const Grid<Fragment> samples = rasterizer_.band(index);
    Grid<PixelSums> sums(width_, kBandRows + 2 * kMargin);
    for (int y = 0; y < samples.height; ++y) {
      const Footprint& rows = rows_[std::size_t(index) * kBandRows * kGrid + std::size_t(y)];
      const std::vector<PixelSums> line = filtered_line(samples, y);
      for (int i = 0; i < 4; ++i) {
        const double weight = rows.weights[std::size_t(i)];
        if (weight == 0) continue;
        add(line.data(), weight, &sums.at(0, rows.first + i - first_row(index)));
      }
    }
    return sums;
  }

  /// A row of samples, filtered along x.
  std::vector<PixelSums> filtered_line(const Grid<Fragment>& samples, int y) const {
    auto line = std::vector<PixelSums>(std::size_t(width_));
    for (int x = 0; x < samples.width; ++x) {
      const Fragment& fragment = samples.at(x, y);
      if (!fragment.covered()) continue;
      const PixelSums sample = sums_of(shading_.color(fragment));
      const Footprint& columns = columns_[std::size_t(x)];
      for (int i = 0; i < 4; ++i) {
        const int column = columns.first + i;
        if (column < 0 || column >= width_) continue;
        line[std::size_t(column)].add(sample, columns.weights[std::size_t(i)]);
      }
    }
    return line;
  }

  /// Adds a row of pixels to another.
  void add(const PixelSums* row, double weight, PixelSums* sums) const {
    for (int x = 0; x < width_; ++x) sums[x].add(row[x], weight);
  }

  const Shading& shading_;
  int width_, height_;
  std::vector<Footprint> columns_, rows_;
  Rasterizer rasterizer_;
};

/// The mean of a pixel's two estimates.
Channels mean_of(const FilteredImage& image, std::size_t pixel) {
  Channels mean{};
  for (std::size_t c = 0; c < mean.size(); ++c) {
    mean[c] = (image.halves[0].pixels[pixel][c] + image.halves[1].pixels[pixel][c]) / 2;
  }
  return mean;
}

/// Of one channel of a pixel, from the means of a sample and of its square, and its range.
void set_spread(double mean, double square, double low, double high, double& spread,
                double& reach) {
  spread = std::sqrt(std::max(0.0, square - mean * mean));
  reach = std::max({0.0, high - mean, mean - low});
}

/// Fills spread and reach from all samples' sums, of which there are `passes`.
void resolve(const Grid<PixelSums>& sums, int passes, FilteredImage& image) {
  for (std::size_t p = 0; p < sums.pixels.size(); ++p) {
    const PixelSums& pixel = sums.pixels[p];
    const Channels mean = mean_of(image, p);
    Channels &spread = image.spread.pixels[p], &reach = image.reach.pixels[p];
    // The background is among the samples unless all are covered.
    const bool is_full = mean[3] > 1 - 1e-9, is_blank = pixel.weighted[3] == 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double low = is_full ? pixel.low[c] : std::min(0.0, pixel.low[c]);
      const double high = is_full ? pixel.high[c] : std::max(0.0, pixel.high[c]);
      set_spread(mean[c], pixel.weighted[4 + c] / passes, low, high, spread[c], reach[c]);
    }
    set_spread(mean[3], mean[3], is_full ? 1 : 0, is_blank ? 0 : 1, spread[3], reach[3]);
  }
}

}  // namespace

FilteredImage render_filtered(const Scene& scene, const Shot& shot, const PixelFilter& filter,
                              int samples) {
  const int count = (samples + 2 * kGrid * kGrid - 1) / (2 * kGrid * kGrid);  // passes of a half
  const Shading shading(scene, shot);
  const Grid<Channels> empty(scene.view.image.width, scene.view.image.height);
  FilteredImage image{{empty, empty}, empty, empty};
  Grid<PixelSums> sums(empty.width, empty.height);
  for (int i = 0; i < 2 * count; ++i) {
    check_interrupted();
    const CellPlace place = cell_place(i / 2, count, i % 2);
    const Grid<PixelSums> pass = FilterPass(scene, shading, filter, place).draw();
    Grid<Channels>& half = image.halves[std::size_t(i % 2)];
    for (std::size_t p = 0; p < pass.pixels.size(); ++p) {
      const PixelSums& pixel = pass.pixels[p];
      for (std::size_t c = 0; c < 4; ++c) half.pixels[p][c] += pixel.weighted[c] / count;
      sums.pixels[p].add(pixel, 1);
    }
  }
  resolve(sums, 2 * count, image);
  return image;
}

}  // namespace lumaknot
