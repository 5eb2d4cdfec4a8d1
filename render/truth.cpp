#include "render/truth.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "render/shading.h"

namespace lumaknot {
namespace {

/// A colour and what of it is covered.
struct Sample {
  Vec3d color;
  double coverage = 0;

  friend Sample operator+(const Sample& a, const Sample& b) {
    return {a.color + b.color, a.coverage + b.coverage};
  }
  friend Sample operator-(const Sample& a, const Sample& b) {
    return {a.color - b.color, a.coverage - b.coverage};
  }
  friend Sample operator*(const Sample& a, double s) { return {a.color * s, a.coverage * s}; }
};

double size_of(const Sample& s) {
  return std::max(
      {std::abs(s.color.x), std::abs(s.color.y), std::abs(s.color.z), std::abs(s.coverage)});
}

/// Pixels of the exact tube's image.
class ExactPixels {
 public:
  ExactPixels(const Scene& scene, const KnotSpec& knot)
      : tube_(knot),
        projection_(scene.view.camera, scene.view.image.width, scene.view.image.height),
        eye_(scene.view.camera.position),
        near_(near_depth(scene.view.camera)),
        shot_{"final", Stage::kFinal, exact_material(scene.view.material)},
        shading_(scene, shot_) {}

  ExactFragment at(double x, double y) const {
    return tube_.first({eye_, projection_.to_world(projection_.ray(x, y))}, near_);
  }

  Sample sample(const ExactFragment& seen) const {
    return {shading_.color(seen.fragment), seen.fragment.covered() ? 1.0 : 0.0};
  }

 private:
  ExactTube tube_;
  Projection projection_;
  Vec3d eye_;
  double near_;
  Shot shot_;
  Shading shading_;
};

/// A square of a pixel with the mean of the samples at its quarters' centres.
struct Cell {
  double x, y, side;  ///< top left corner, pixels
  Sample mean;
  double error;  ///< estimated, of the mean, times the area
};

/// The mean over one pixel: the square whose error is estimated largest is cut into quarters, until
/// the sum of all is within the tolerance.
class AreaPixel {
 public:
  AreaPixel(const ExactPixels& pixels, double x, double y, double tolerance) : pixels_(pixels) {
    quarter({x, y, 1, mean_of(x, y, 1), 1});
    double error = sum_of_errors();
    while (error > tolerance && cells_.size() < kMostCells) {
      const auto worst = std::ranges::max_element(cells_, {}, &Cell::error);
      const Cell cell = *worst;
      *worst = cells_.back();
      cells_.pop_back();
      quarter(cell);
      error = sum_of_errors();
    }
  }

  Sample mean() const {
    Sample sum;
    for (const Cell& cell : cells_) sum = sum + cell.mean * (cell.side * cell.side);
    return sum;
  }
  double sum_of_errors() const {
    double sum = 0;
    for (const Cell& cell : cells_) sum += cell.error;
    return sum;
  }

 private:
  static constexpr std::size_t kMostCells = 1 << 12;

  Sample mean_of(double x, double y, double side) const {
    Sample sum;
    for (const auto& [i, j] : {std::array{1, 1}, {3, 1}, {1, 3}, {3, 3}}) {
      sum = sum + pixels_.sample(pixels_.at(x + side * i / 4, y + side * j / 4));
    }
    return sum * 0.25;
  }

  void quarter(const Cell& cell) {
    const double half = cell.side / 2;
    std::array<Cell, 4> parts;
    Sample fine;
    for (int k = 0; k < 4; ++k) {
      const double x = cell.x + half * (k % 2), y = cell.y + half * (k / 2);
      parts[std::size_t(k)] = {x, y, half, mean_of(x, y, half), 0};
      fine = fine + parts[std::size_t(k)].mean * 0.25;
    }
    const double error = size_of(fine - cell.mean) * cell.side * cell.side;
    for (Cell& part : parts) {
      part.error = error / 4;
      cells_.push_back(part);
    }
  }

  const ExactPixels& pixels_;
  std::vector<Cell> cells_;
};

}  // namespace

Material exact_material(const Material& material) {
  Material exact = material;
  exact.rate = Rate::kPixel;
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
  Truth truth{Image(width, height), Grid<float>(width, height)};
  std::mutex reporting;
  int finished = 0;
  oneapi::tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      Sample sample;
      double error = 0;
      if (options.sampling == TruthSampling::kPoint) {
        const ExactFragment seen = pixels.at(x + 0.5, y + 0.5);
        sample = pixels.sample(seen);
        error = seen.decided ? 0 : 1;
      } else {
        const AreaPixel pixel(pixels, x, y, options.tolerance);
        sample = pixel.mean();
        error = pixel.sum_of_errors();
      }
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

}  // namespace lumaknot
