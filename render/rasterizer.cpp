#include "render/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/exact_sign.h"

namespace lumaknot {
namespace {

Vec3d absolute(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// A bound of the rounding error of a component of cross(b, c), and later of its product with a
/// ray: eight roundings of terms no larger than these, with room to spare.
Vec3d cross_doubt(const Vec3d& b, const Vec3d& c) {
  const Vec3d p = absolute(b), q = absolute(c);
  constexpr double kRoundings = 16 * std::numeric_limits<double>::epsilon();
  return Vec3d{p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x} * kRoundings;
}

/// The sign of a . (b x c), whose double value is `value` and can be off by `doubt`.
int volume_sign(double value, double doubt, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (std::abs(value) > doubt) return value > 0 ? 1 : -1;
  return std::isfinite(doubt) ? exact_volume_sign(a, b, c) : 0;
}

Edges edges_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double volume = dot(a, cross(b, c));
  const int sign = volume_sign(volume, dot(absolute(a), cross_doubt(b, c)), a, b, c);
  if (sign < 0) {  // seen from behind
    Edges edges = edges_of(a, c, b);
    edges.swapped = true;
    return edges;
  }
  return {{a, b, c},
          {cross(b, c), cross(c, a), cross(a, b)},
          {cross_doubt(b, c), cross_doubt(c, a), cross_doubt(a, b)},
          sign == 0 ? 0 : volume,
          false};
}

/// The top-left rule for a sample on an edge: inside if it is a left edge or a horizontal top edge.
/// Image rows run opposite to view space's y.
bool owns_its_samples(const Edges& edges, std::size_t i) {
  const Vec3d &b = edges.corners[(i + 1) % 3], &c = edges.corners[(i + 2) % 3];
  const int right = exact_volume_sign({1, 0, 0}, b, c);
  return right > 0 || (right == 0 && exact_volume_sign({0, 1, 0}, b, c) < 0);
}

bool is_inside(const Edges& edges, const Vec3d& ray, const std::array<double, 3>& values) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int sign = volume_sign(values[i], dot(edges.doubt[i], absolute(ray)), ray,
                                 edges.corners[(i + 1) % 3], edges.corners[(i + 2) % 3]);
    if (sign < 0 || (sign == 0 && !owns_its_samples(edges, i))) return false;
  }
  return true;
}

/// `x` rounded down or up into [0, limit]; NaN becomes 0.
int clamped(double x, int limit) { return x > 0 ? int(std::min(x, double(limit))) : 0; }

}  // namespace

namespace {

std::vector<Vec3d> view_positions_of(const TriangleMesh& mesh, const Projection& projection) {
  std::vector<Vec3d> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3d& p : mesh.positions) positions.push_back(projection.to_view(p));
  return positions;
}

}  // namespace

Rasterizer::Rasterizer(const TriangleMesh& mesh, const Camera& camera, int width, int height,
                       int band_height)
    : Rasterizer(mesh, view_positions_of(mesh, Projection(camera, width, height)),
                 Projection(camera, width, height), near_depth(camera), width, height,
                 band_height) {}

Rasterizer::Rasterizer(const TriangleMesh& mesh, std::vector<Vec3d> view_positions,
                       const Projection& projection, double nearest, int width, int height,
                       int band_height)
    : mesh_(mesh),
      projection_(projection),
      width_(width),
      height_(height),
      band_height_(band_height),
      near_(nearest),
      view_positions_(std::move(view_positions)),
      image_points_(view_positions_.size()),
      bins_(std::size_t((height + band_height - 1) / band_height)) {
  for (std::size_t v = 0; v < view_positions_.size(); ++v) {
    if (!(view_positions_[v].z >= near_)) continue;
    const Vec3d point = projection_.to_image(view_positions_[v]);
    image_points_[v] = {point.x, point.y};
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Bounds covered = bounds(mesh.triangles[t]);
    if (covered.empty()) continue;
    for (int b = covered.y0 / band_height; b <= (covered.y1 - 1) / band_height; ++b) {
      bins_[std::size_t(b)].push_back(t);
    }
  }
}

Rasterizer::Bounds Rasterizer::bounds(const Triangle& triangle, double margin) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double x0 = kInfinity, x1 = -kInfinity, y0 = kInfinity, y1 = -kInfinity;
  int in_front = 0;
  for (const std::uint32_t v : triangle) {
    if (!(view_positions_[v].z >= near_)) continue;
    ++in_front;
    const auto [x, y] = image_points_[v];
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  // Where an edge meets the near plane can't be computed reliably from distant corners.
  if (in_front == 1 || in_front == 2) return {0, width_, 0, height_};
  const double more = margin + 1.0 / 16;  // the part rules out rounding
  const auto first = [&](double low, int size) {
    return clamped(std::ceil(low - 0.5 - more), size);
  };
  const auto end = [&](double high, int size) {
    return clamped(std::floor(high - 0.5 + more) + 1, size);
  };
  return {first(x0, width_), end(x1, width_), first(y0, height_), end(y1, height_)};
}

Grid<Fragment> Rasterizer::band(int index) const {
  const int first_row = index * band_height_;
  Grid<Fragment> band(width_, std::min(band_height_, height_ - first_row));
  for (const std::uint32_t triangle : bins_[std::size_t(index)]) draw(triangle, first_row, band);
  return band;
}

Edges Rasterizer::edges(std::uint32_t triangle) const {
  const Triangle& corners = mesh_.triangles[triangle];
  return edges_of(view_positions_[corners[0]], view_positions_[corners[1]],
                  view_positions_[corners[2]]);
}

void Rasterizer::draw(std::uint32_t triangle, int first_row, Grid<Fragment>& band) const {
  const Bounds covered = bounds(mesh_.triangles[triangle]);
  const int y0 = std::max(covered.y0, first_row);
  const int y1 = std::min(covered.y1, first_row + band.height);
  if (covered.empty() || y0 >= y1) return;
  const Edges edges = this->edges(triangle);
  for (int y = y0; y < y1; ++y) {
    for (int x = covered.x0; x < covered.x1; ++x) {
      draw_at(triangle, edges, projection_.ray(x + 0.5, y + 0.5), near_, band.at(x, y - first_row));
    }
  }
}

void Rasterizer::draw_at(std::uint32_t triangle, const Edges& edges, const Vec3d& ray,
                         double nearest, Fragment& seen) const {
  if (!(edges.volume > 0) || !std::isfinite(edges.volume)) return;  // edge on, or too large
  const std::array<double, 3> values{dot(edges.planes[0], ray), dot(edges.planes[1], ray),
                                     dot(edges.planes[2], ray)};
  if (!is_inside(edges, ray, values)) return;
  const double sum = values[0] + values[1] + values[2];
  const double depth = edges.volume / sum;
  if (!(depth >= nearest) || (seen.covered() && depth > seen.depth)) return;
  const std::size_t second = edges.swapped ? 2 : 1;
  seen =
      fragment(triangle, depth, {values[0] / sum, values[second] / sum, values[3 - second] / sum});
}

Fragment Rasterizer::fragment(std::uint32_t triangle, double depth,
                              const std::array<double, 3>& weights) const {
  Fragment result;
  result.triangle = triangle;
  result.depth = depth;
  result.weights = weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh_.triangles[triangle][i];
    result.position = result.position + mesh_.positions[v] * weights[i];
    result.normal = result.normal + mesh_.normals[v] * weights[i];
    result.uv.u += mesh_.uvs[v].u * weights[i];
    result.uv.v += mesh_.uvs[v].v * weights[i];
  }
  return result;
}

}  // namespace lumaknot
