#include "render/surface_probe.h"

#include <algorithm>
#include <array>

namespace lumaknot {
namespace {

constexpr int kTile = 4;  // samples: about the size of the triangles of common meshes

/// A corner of a clipped triangle: its image point and the weights of the triangle's corners there,
/// linear in the image.
struct ClipCorner {
  double x = 0, y = 0;
  std::array<double, 3> weights{};
};

ClipCorner between(const ClipCorner& a, const ClipCorner& b, double share) {
  const auto mix = [share](double p, double q) { return p + (q - p) * share; };
  ClipCorner result{mix(a.x, b.x), mix(a.y, b.y), {}};
  for (std::size_t i = 0; i < 3; ++i) result.weights[i] = mix(a.weights[i], b.weights[i]);
  return result;
}

/// Keeps the part of `polygon` where `inside` is not negative; `inside` is linear.
template <class F>
std::vector<ClipCorner> clipped(const std::vector<ClipCorner>& polygon, F inside) {
  std::vector<ClipCorner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClipCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(between(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

/// A triangle next to the point looked at, and the corners of its part there.
struct NearTriangle {
  std::uint32_t index;
  Edges edges;
  std::vector<ClipCorner> part;
};

/// Whether the triangle lies before the eye and wholly on one side of the square.
bool misses_square(const Rasterizer& rasterizer, std::uint32_t triangle, double x, double y,
                   double distance) {
  int left = 0, right = 0, above = 0, below = 0;
  for (const std::uint32_t v : rasterizer.mesh().triangles[triangle]) {
    const Vec3d& view = rasterizer.view_position(v);
    if (!(view.z >= rasterizer.nearest())) return false;
    const Vec3d image = rasterizer.projection().to_image(view);
    left += image.x<x - distance, right += image.x> x + distance;
    above += image.y<y - distance, below += image.y> y + distance;
  }
  return left == 3 || right == 3 || above == 3 || below == 3;
}

/// The corners of the triangle's part within the square; none if it reaches before the near plane.
std::vector<ClipCorner> part_in_square(const Rasterizer& rasterizer, std::uint32_t triangle,
                                       double x, double y, double distance) {
  const Triangle& corners = rasterizer.mesh().triangles[triangle];
  std::vector<ClipCorner> polygon(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& view = rasterizer.view_position(corners[i]);
    if (!(view.z >= rasterizer.nearest())) return {};
    const Vec3d image = rasterizer.projection().to_image(view);
    polygon[i].x = image.x, polygon[i].y = image.y, polygon[i].weights[i] = 1;
  }
  polygon = clipped(polygon, [&](const ClipCorner& c) { return c.x - (x - distance); });
  polygon = clipped(polygon, [&](const ClipCorner& c) { return x + distance - c.x; });
  polygon = clipped(polygon, [&](const ClipCorner& c) { return c.y - (y - distance); });
  return clipped(polygon, [&](const ClipCorner& c) { return y + distance - c.y; });
}

/// The surface point of a corner, with weights corrected for perspective.
Fragment fragment_at(const Rasterizer& rasterizer, std::uint32_t triangle,
                     const ClipCorner& corner) {
  const Triangle& corners = rasterizer.mesh().triangles[triangle];
  std::array<double, 3> weights{};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = corner.weights[i] / rasterizer.view_position(corners[i]).z;
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return rasterizer.fragment(triangle, 1 / sum, weights);
}

/// What the image point sees of the triangles.
Fragment front(const Rasterizer& rasterizer, const std::vector<NearTriangle>& triangles, double x,
               double y) {
  const Vec3d ray = rasterizer.projection().ray(x, y);
  Fragment seen;
  for (const NearTriangle& t : triangles) {
    rasterizer.draw_at(t.index, t.edges, ray, rasterizer.nearest(), seen);
  }
  return seen;
}

/// Appends the corners of the triangle's part that no other triangle hides.
void add_visible_corners(const Rasterizer& rasterizer, const std::vector<NearTriangle>& triangles,
                         const NearTriangle& triangle, std::vector<Fragment>& seen) {
  constexpr double kSameDepth = 1e-6;  // of triangles that meet there
  for (const ClipCorner& corner : triangle.part) {
    const Fragment here = fragment_at(rasterizer, triangle.index, corner);
    const Fragment first = front(rasterizer, triangles, corner.x, corner.y);
    if (first.covered() && first.depth < here.depth * (1 - kSameDepth)) continue;
    seen.push_back(here);
  }
}

}  // namespace

SurfaceProbe::SurfaceProbe(const TriangleMesh& mesh, const Camera& camera, int width, int height)
    : rasterizer_(mesh, camera, width, height, height),
      tiles_((width + kTile - 1) / kTile, (height + kTile - 1) / kTile) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Rasterizer::Bounds bounds = rasterizer_.bounds(mesh.triangles[t], 0.5);
    if (bounds.empty()) continue;
    for (int row = bounds.y0 / kTile; row <= (bounds.y1 - 1) / kTile; ++row) {
      for (int column = bounds.x0 / kTile; column <= (bounds.x1 - 1) / kTile; ++column) {
        tiles_.at(column, row).push_back(t);
      }
    }
  }
}

const std::vector<std::uint32_t>& SurfaceProbe::tile_at(double x, double y) const {
  const int column = std::clamp(int(x / kTile), 0, tiles_.width - 1);
  const int row = std::clamp(int(y / kTile), 0, tiles_.height - 1);
  return tiles_.at(column, row);
}

Fragment SurfaceProbe::at(double x, double y, double beyond) const {
  const Vec3d ray = rasterizer_.projection().ray(x, y);
  Fragment seen;
  for (const std::uint32_t triangle : tile_at(x, y)) {
    rasterizer_.draw_at(triangle, rasterizer_.edges(triangle), ray,
                        std::max(rasterizer_.nearest(), beyond), seen);
  }
  return seen;
}

std::vector<std::uint32_t> SurfaceProbe::triangles_around(double x, double y,
                                                          double distance) const {
  std::vector<std::uint32_t> all;
  const std::vector<std::uint32_t>* previous = nullptr;
  for (const double py : {y - distance, y + distance}) {
    for (const double px : {x - distance, x + distance}) {
      const std::vector<std::uint32_t>& tile = tile_at(px, py);
      if (&tile != previous) all.insert(all.end(), tile.begin(), tile.end());
      previous = &tile;
    }
  }
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

std::vector<Fragment> SurfaceProbe::around(double x, double y, double distance) const {
  std::vector<NearTriangle> triangles;
  for (const std::uint32_t t : triangles_around(x, y, distance)) {
    if (misses_square(rasterizer_, t, x, y, distance)) continue;
    triangles.push_back({t, rasterizer_.edges(t), part_in_square(rasterizer_, t, x, y, distance)});
  }
  std::vector<Fragment> seen;
  for (int j = -2; j <= 2; ++j) {
    for (int i = -2; i <= 2; ++i) {
      if (i == 0 && j == 0) continue;
      seen.push_back(front(rasterizer_, triangles, x + distance * i / 2, y + distance * j / 2));
    }
  }
  for (const NearTriangle& t : triangles) add_visible_corners(rasterizer_, triangles, t, seen);
  return seen;
}

}  // namespace lumaknot
