#include "render/exact_pixels.h"

#include <algorithm>
#include <array>

#include "render/truth.h"

namespace lumaknot {
namespace {

double size_of(const Sample& s) {
  return std::max(
      {std::abs(s.color.x), std::abs(s.color.y), std::abs(s.color.z), std::abs(s.coverage)});
}

/// A square of a pixel with the mean of the samples at its quarters' centres.
struct Cell {
  double x, y, side;  ///< top left corner and side, pixels
  Sample mean;
  double error;  ///< estimated, of the mean, times the area
};

/// The mean over the pixel whose top left corner is (x, y); `sample` gives the one at a point.
template <class SampleAt>
class AreaPixel {
 public:
  AreaPixel(const SampleAt& sample, double x, double y, double tolerance) : sample_(sample) {
    quarter({x, y, 1, mean_of(x, y, 1), 1});
    while (error() > tolerance && cells_.size() < kMostCells) {
      const auto worst = std::ranges::max_element(cells_, {}, &Cell::error);
      const Cell cell = *worst;
      *worst = cells_.back();
      cells_.pop_back();
      quarter(cell);
    }
  }

  PixelTruth result() const {
    Sample sum;
    for (const Cell& cell : cells_) sum = sum + cell.mean * (cell.side * cell.side);
    return {sum, error()};
  }

 private:
  static constexpr std::size_t kMostCells = 1 << 12;

  double error() const {
    double sum = 0;
    for (const Cell& cell : cells_) sum += cell.error;
    return sum;
  }

  Sample mean_of(double x, double y, double side) const {
    Sample sum;
    for (const auto& [i, j] : {std::array{1, 1}, {3, 1}, {1, 3}, {3, 3}}) {
      sum = sum + sample_(x + side * i / 4, y + side * j / 4);
    }
    return sum * 0.25;
  }

  /// The parts share the difference that quartering made. Across an edge each halving leaves 0.35
  /// of it on the average, elsewhere less, so it stands for all that is left.
  void quarter(const Cell& cell) {
    const double half = cell.side / 2;
    std::array<Cell, 4> parts;
    Sample fine;
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = cell.x + half * double(k % 2), y = cell.y + half * double(k / 2);
      parts[k] = {x, y, half, mean_of(x, y, half), 0};
      fine = fine + parts[k].mean * 0.25;
    }
    for (Cell& part : parts) {
      part.error = size_of(fine - cell.mean) * part.side * part.side;
      cells_.push_back(part);
    }
  }

  const SampleAt& sample_;
  std::vector<Cell> cells_;
};

/// Lagrange's polynomials through 0, 1/2 and 1.
std::array<double, 3> quadratic_weights(double x) {
  return {(2 * x - 1) * (x - 1), 4 * x * (1 - x), x * (2 * x - 1)};
}

/// What the nine points at multiples of half a pixel show, row by row.
class Patch {
 public:
  explicit Patch(const std::array<const ExactFragment*, 9>& nodes) : nodes_(nodes) {}

  bool empty() const {
    return std::ranges::none_of(nodes_, [](const auto* n) { return n->fragment.covered(); });
  }

  /// Whether all nodes lie near each other on the surface, no texture seam between them.
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

/// Whether the patch may stand for the surface: where its error is largest, the colour is right.
bool stands(const ExactPixels& pixels, const Patch& patch, double x, double y, double tolerance) {
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
  if (stands(pixels, patch, x, y, tolerance)) {
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

ExactFragment ExactPixels::at(double x, double y) const {
  return tube_.first({eye_, projection_.to_world(projection_.ray(x, y))}, near_);
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

}  // namespace lumaknot
