/// Shared by the renderer's tests: an oracle independent of rasterisation, and meshes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "math/angle.h"
#include "render/rasterizer.h"
#include "scene/spec.h"

namespace lumaknot::testing {

/// A camera on the z axis whose frame is the world's, so that view space is known without rounding.
inline Camera axis_camera(double distance = 4, double fov_degrees = 90) {
  return {.position = {0, 0, distance},
          .target = {0, 0, 0},
          .up = {0, 1, 0},
          .fov_degrees = fov_degrees};
}

/// The world-space direction through the image point (x, y) whose length along the line of sight is
/// one, from the textbook's pinhole camera.
inline Vec3d world_ray(const Camera& camera, int width, int height, double x, double y) {
  const Vec3d forward = normalize(camera.target - camera.position);
  const Vec3d right = normalize(cross(forward, camera.up));
  const Vec3d up = cross(right, forward);
  const double half = std::tan(camera.fov_degrees / 2 * kPi / 180);
  return forward + right * (half * width / height * (2 * x / width - 1)) +
         up * (half * (1 - 2 * y / height));
}

/// Where a ray meets a triangle's plane: the distance and the weights of its three corners.
struct Hit {
  double t;
  double weights[3];
  double margin() const { return std::min({weights[0], weights[1], weights[2]}); }
};

/// Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997; no culling, and
/// misses have a negative margin.
inline std::optional<Hit> intersect(const Vec3d& origin, const Vec3d& direction, const Vec3d& a,
                                    const Vec3d& b, const Vec3d& c) {
  const Vec3d e1 = b - a, e2 = c - a, p = cross(direction, e2);
  const double determinant = dot(e1, p);
  if (determinant == 0) return std::nullopt;
  const Vec3d s = origin - a, q = cross(s, e1);
  const double u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
  return Hit{dot(e2, q) / determinant, {1 - u - v, u, v}};
}

/// Adds a vertex whose normal and texture coordinates are functions of its position, so that
/// interpolated values follow from the position alone.
inline std::uint32_t add_vertex(TriangleMesh& mesh, const Vec3d& position) {
  mesh.positions.push_back(position);
  mesh.normals.push_back({position.y, position.z, position.x});
  mesh.uvs.push_back({position.x - position.z, 2 * position.y});
  return std::uint32_t(mesh.positions.size() - 1);
}

inline void add_triangle(TriangleMesh& mesh, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const std::uint32_t i = add_vertex(mesh, a), j = add_vertex(mesh, b), k = add_vertex(mesh, c);
  mesh.triangles.push_back({i, j, k});
}

/// A square of side 2 `half` in the plane z = `z`, normals up, uv in [0, 1].
inline TriangleMesh square(double half, double z = 0) {
  TriangleMesh mesh;
  mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The unit sphere about the origin, `rings` from pole to pole and twice as many around.
inline TriangleMesh sphere(int rings) {
  TriangleMesh mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= around; ++j) {
      const double theta = kPi * i / rings, phi = kTurn * j / around;
      const Vec3d p{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta)};
      mesh.positions.push_back(p);
      mesh.normals.push_back(p);
      mesh.uvs.push_back({double(j) / around, 1 - double(i) / rings});
    }
  }
  const auto at = [&](int i, int j) { return std::uint32_t(i * (around + 1) + j); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// The whole image, drawn in bands of `band_height` rows.
inline Grid<Fragment> draw(const TriangleMesh& mesh, const Camera& camera, int width, int height,
                           int band_height = 16) {
  const Rasterizer rasterizer(mesh, camera, width, height, band_height);
  Grid<Fragment> all(0, 0);
  all.width = width;
  for (int b = 0; b < rasterizer.bands(); ++b) {
    const Grid<Fragment> band = rasterizer.band(b);
    all.height += band.height;
    all.pixels.insert(all.pixels.end(), band.pixels.begin(), band.pixels.end());
  }
  return all;
}

inline int covered_samples(const Grid<Fragment>& fragments) {
  int count = 0;
  for (const Fragment& f : fragments.pixels) count += f.covered();
  return count;
}

/// How many of the mesh's triangles, each drawn alone, draw each sample.
inline std::vector<int> times_drawn(const TriangleMesh& mesh, const Camera& camera, int width,
                                    int height) {
  std::vector<int> counts(std::size_t(width) * std::size_t(height));
  TriangleMesh one = mesh;
  for (const Triangle& t : mesh.triangles) {
    one.triangles = {t};
    const Grid<Fragment> seen = draw(one, camera, width, height);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += seen.pixels[i].covered();
  }
  return counts;
}

inline bool same(const Fragment& a, const Fragment& b) {
  return a.triangle == b.triangle && a.depth == b.depth && a.position == b.position &&
         a.normal == b.normal && a.uv == b.uv;
}

/// Numbers that are the same on every machine: a distribution's algorithm is not standardised.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * double(engine_()) / 4294967296.0;
  }
  Vec3d point(double extent) {
    const double x = between(-extent, extent), y = between(-extent, extent);
    return {x, y, between(-extent, extent)};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace lumaknot::testing
