#include "render/exact/pixels.h"

#include <algorithm>
#include <array>

#include "render/exact/truth.h"

namespace lumaknot::exact {
namespace {

double size_of(const Sample& s) {
  return std::max(
      {std::abs(s.color.x), std::abs(s.color.y), std::abs(s.color.z), std::abs(s.coverage)});
}

/// A square within a pixel and its nine samples: corners, edge midpoints and centre.
struct Cell {
  double x, y, side;              ///< top left corner and side, pixels
  std::array<Sample, 9> samples;  ///< row by row
  double error;                   ///< estimated error of the mean, times the area

  double area() const { return side * side; }

  /// Simpson's rule in both directions.
  Sample mean() const {
    const auto& [a, b, c, d, e, f, g, h, i] = samples;
    return (a + c + g + i + (b + d + f + h) * 4 + e * 16) * (1 / 36.0);
  }
  /// How far that is from the mean of the corners.
  double bend() const {
    return size_of(mean() - (samples[0] + samples[2] + samples[6] + samples[8]) * 0.25);
  }
};

/// The mean over the pixel whose top left corner is (x, y); `sample` gives the value at a point.
template <class SampleAt>
class AreaPixel {
 public:
  AreaPixel(const SampleAt& sample, double x, double y, double tolerance) : sample_(sample) {
    Cell pixel{x, y, 1, {}, 0};
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t column = k % 3, row = k / 3;
      pixel.samples[k] = sample(x + 0.5 * double(column), y + 0.5 * double(row));
    }
    quarter(pixel);
    while (error() > tolerance && cells_.size() < kMaxCells) {
      std::ranges::pop_heap(cells_, {}, &Cell::error);
      const Cell cell = cells_.back();
      cells_.pop_back();
      sum_ -= cell.error;
      squares_ -= cell.error * cell.error;
      quarter(cell);
    }
  }

  PixelTruth result() const {
    Sample sum;
    for (const Cell& cell : cells_) sum = sum + cell.mean() * cell.area();
    return {sum, error()};
  }

 private:
  static constexpr std::size_t kMaxCells = 1 << 13;

  /// Errors of many cells partly cancel: three standard deviations, or their sum if that is
  /// smaller.
  double error() const { return std::min(sum_, 3 * std::sqrt(std::max(squares_, 0.0))); }

  /// The samples of `cell` and sixteen between them, as a 5 x 5 grid.
  std::array<Sample, 25> denser(const Cell& cell) const {
    std::array<Sample, 25> grid;
    for (std::size_t k = 0; k < 25; ++k) {
      const std::size_t i = k % 5, j = k / 5;
      const double step = cell.side / 4;
      grid[k] = i % 2 == 0 && j % 2 == 0
                    ? cell.samples[j / 2 * 3 + i / 2]
                    : sample_(cell.x + step * double(i), cell.y + step * double(j));
    }
    return grid;
  }

  std::array<Cell, 4> parts_of(const Cell& cell) const {
    const std::array<Sample, 25> grid = denser(cell);
    const double half = cell.side / 2;
    std::array<Cell, 4> parts;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t right = k % 2, down = k / 2;
      parts[k] = {cell.x + half * double(right), cell.y + half * double(down), half, {}, 0};
      for (std::size_t n = 0; n < 9; ++n) {
        parts[k].samples[n] = grid[(2 * down + n / 3) * 5 + 2 * right + n % 3];
      }
    }
    return parts;
  }

  /// The change in the mean is taken as the remaining error, shared among the parts in proportion
  /// to their bend; each part's error is at least a quarter of its bend.
  void quarter(const Cell& cell) {
    std::array<Cell, 4> parts = parts_of(cell);
    Sample fine;
    double bends = 0;
    for (const Cell& part : parts) {
      fine = fine + part.mean() * 0.25;
      bends += part.bend();
    }
    const double change = size_of(fine - cell.mean()) * cell.area();
    for (Cell& part : parts) {
      const double share = bends > 0 ? part.bend() / bends : 0.25;
      part.error = std::max(change * share, part.bend() * part.area() / 4);
      sum_ += part.error;
      squares_ += part.error * part.error;
      cells_.push_back(part);
      std::ranges::push_heap(cells_, {}, &Cell::error);
    }
  }

  const SampleAt& sample_;
  std::vector<Cell> cells_;  // a heap, the largest error first
  double sum_ = 0, squares_ = 0;
};

/// Lagrange polynomials for the nodes 0, 1/2 and 1.
std::array<double, 3> quadratic_weights(double x) {
  return {(2 * x - 1) * (x - 1), 4 * x * (1 - x), x * (2 * x - 1)};
}

/// The fragments at the nine multiples of half a pixel, row by row.
class Patch {
 public:
  explicit Patch(const std::array<const ExactFragment*, 9>& nodes) : nodes_(nodes) {}

  bool empty() const {
    return std::ranges::none_of(nodes_, [](const auto* n) { return n->fragment.covered(); });
  }

  /// Whether all nodes are close together on the surface, with no texture seam between them.
  bool coherent() const {
    const ExactFragment& center = *nodes_[4];
    return std::ranges::all_of(nodes_, [&](const ExactFragment* n) {
      return n->fragment.covered() && n->fragment.triangle == center.fragment.triangle &&
             std::abs(n->t - center.t) < 0.2 && std::abs(n->theta - center.theta) < 0.8;
    });
  }

  /// At (x, y) in the pixel, each in [0, 1].
  Fragment at(double x, double y) const {
    const std::array<double, 3> across = quadratic_weights(x), down = quadratic_weights(y);
    Fragment sum;
    sum.triangle = nodes_[4]->fragment.triangle;
    for (std::size_t k = 0; k < 9; ++k) {
      const Fragment& node = nodes_[k]->fragment;
      const double weight = across[k % 3] * down[k / 3];
      sum.depth += node.depth * weight;
      sum.position = sum.position + node.position * weight;
      sum.normal = sum.normal + node.normal * weight;
      sum.uv = {sum.uv.u + node.uv.u * weight, sum.uv.v + node.uv.v * weight};
    }
    sum.normal = normalize(sum.normal);
    return sum;
  }

 private:
  std::array<const ExactFragment*, 9> nodes_;
};

/// Whether the patch may replace the surface: its colour is right where its error is largest.
bool is_accurate(const ExactPixels& pixels, const Patch& patch, double x, double y,
                 double tolerance) {
  if (!patch.coherent()) return false;
  constexpr double kAcross = 0.25, kDown = 0.75;  // near the extremes of x (x - 1/2) (x - 1)
  const Fragment guess = patch.at(kAcross, kDown);
  const Fragment seen = pixels.at(x + kAcross, y + kDown).fragment;
  return seen.covered() && length(guess.normal - seen.normal) < 1e-3 &&
         size_of(pixels.sample(guess) - pixels.sample(seen)) < tolerance / 4;
}

PixelTruth area_pixel(const ExactPixels& pixels, const Patch& patch, double x, double y,
                      double tolerance) {
  if (patch.empty() && !pixels.at(x + 0.25, y + 0.75).fragment.covered()) return {};
  if (is_accurate(pixels, patch, x, y, tolerance)) {
    const auto smooth = [&](double u, double v) { return pixels.sample(patch.at(u - x, v - y)); };
    return AreaPixel(smooth, x, y, tolerance).result();
  }
  const auto along_rays = [&](double u, double v) {
    return pixels.sample(pixels.at(u, v).fragment);
  };
  return AreaPixel(along_rays, x, y, tolerance).result();
}

}  // namespace

ExactPixels::ExactPixels(const Scene& scene, const KnotSpec& knot)
    : tube_(knot),
      projection_(scene.view.camera, scene.view.image.width, scene.view.image.height),
      eye_(scene.view.camera.position),
      near_(near_depth(scene.view.camera)),
      shot_{"final", Stage::kFinal, exact_material(scene.view.material)},
      shading_(scene, shot_) {}

ExactFragment ExactPixels::at(double x, double y, double beyond) const {
  return tube_.first({eye_, projection_.to_world(projection_.ray(x, y))}, beyond);
}

std::vector<PixelTruth> area_row(const ExactPixels& pixels, int y, int width, double tolerance) {
  std::array<std::vector<ExactFragment>, 3> lines;  // at y, y + 1/2 and y + 1
  for (std::size_t j = 0; j < 3; ++j) {
    for (int i = 0; i <= 2 * width; ++i) {
      lines[j].push_back(pixels.at(0.5 * i, y + 0.5 * double(j)));
    }
  }
  std::vector<PixelTruth> row;
  for (int x = 0; x < width; ++x) {
    std::array<const ExactFragment*, 9> nodes;
    for (std::size_t k = 0; k < 9; ++k) nodes[k] = &lines[k / 3][2 * std::size_t(x) + k % 3];
    row.push_back(area_pixel(pixels, Patch(nodes), x, y, tolerance));
  }
  return row;
}

}  // namespace lumaknot::exact
