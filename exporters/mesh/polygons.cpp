#include "exporters/mesh/polygons.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/mesh/edges.h"
#include "exporters/mesh/hash_table.h"
#include "exporters/mesh/triangulate.h"
#include "exporters/text/scanner.h"
#include "system/error.h"

namespace lumaknot {
namespace {

/// The unit vector along `v`, of any length; zero for zero.
Vec3d direction(const Vec3d& v) {
  const double max = largest_magnitude(v);
  return max > 0 ? normalize(v / max) : Vec3d{};
}

bool is_zero(const Vec3d& v) { return v == Vec3d{}; }

void check_sizes(const Polygons& polygons, std::string_view name) {
  if (polygons.sizes.empty()) {
    throw Error(
        fmt::format("{} has no faces: its format differs from its extension, or it has "
                    "only points and lines; export the mesh's surface",
                    name));
  }
  const std::size_t max = std::max({polygons.positions.size(), polygons.normals.size(),
                                    polygons.uvs.size(), polygons.corners.size()});
  if (max >= kNoIndex) {
    throw Error(
        fmt::format("{} has {} vertices or corners, more than 2^32 - 2; simplify "
                    "the mesh",
                    name, max));
  }
}

void check_uvs(const Polygons& polygons, std::string_view name) {
  const auto lacks_uv = [](const PolygonCorner& corner) { return corner.uv == kNoIndex; };
  constexpr std::string_view kRemedy =
      R"(give it some, or set texture to a plain {"color": [r, g, b]})";
  if (std::ranges::all_of(polygons.corners, lacks_uv)) {
    throw Error(fmt::format("{} has no texture coordinates; {}", name, kRemedy));
  }
  auto corner = polygons.corners.begin();
  for (std::size_t polygon = 0; polygon < polygons.sizes.size(); ++polygon) {
    const auto end = corner + polygons.sizes[polygon];
    if (std::any_of(corner, end, lacks_uv)) {
      throw file_error(name, polygons.unit, polygons.places[polygon],
                       fmt::format("a corner has no texture coordinate; {}", kRemedy));
    }
    corner = end;
  }
}

/// Triangles that index corners.
using CornerTriangles = Bulk<Triangle>;

CornerTriangles cut(const Polygons& polygons, std::string_view name) {
  CornerTriangles triangles;
  triangles.reserve(polygons.sizes.size());
  std::vector<Vec3d> points;
  const auto position = [&](std::uint32_t corner) { return polygons.corners[corner].position; };
  for_each_loop(polygons, [&](std::size_t polygon, std::span<const std::uint32_t> loop) {
    points.clear();
    for (const std::uint32_t corner : loop) points.push_back(polygons.positions[position(corner)]);
    if (loop.size() > kMaxConcaveCorners && !is_convex(points)) {
      throw file_error(name, polygons.unit, polygons.places[polygon],
                       fmt::format("a concave face of {} corners, more than {}; cut it "
                                   "into triangles",
                                   loop.size(), kMaxConcaveCorners));
    }
    for (const auto& [a, b, c] : triangulate(points)) {
      const Triangle t{loop[a], loop[b], loop[c]};
      const bool is_line = position(t[0]) == position(t[1]) || position(t[1]) == position(t[2]) ||
                           position(t[2]) == position(t[0]);
      if (!is_line) triangles.push_back(t);
    }
  });
  if (triangles.empty()) {
    throw Error(fmt::format("{} has no faces, only points and lines; {}", name, kExportAgain));
  }
  return triangles;
}

/// Unit normals for corners, from the file or smooth.
class Normals {
 public:
  Normals(const Polygons& polygons, const CornerTriangles& triangles) : polygons_(polygons) {
    file_.reserve(polygons.normals.size());
    for (const Vec3d& n : polygons.normals) file_.push_back(direction(n));
    const bool needs_smooth = std::ranges::any_of(
        polygons.corners, [&](const PolygonCorner& c) { return is_zero(in_file(c)); });
    if (needs_smooth) make_smooth(triangles);
  }

  /// If the file and its faces give none, that of the triangle, else +z.
  Vec3d of(std::uint32_t corner, const Triangle& triangle) const {
    const PolygonCorner& c = polygons_.corners[corner];
    const Vec3d in_file_or_zero = in_file(c);
    if (!is_zero(in_file_or_zero)) return in_file_or_zero;
    if (!is_zero(smooth_[c.position])) return smooth_[c.position];
    const Vec3d flat = flat_normal(triangle);
    return is_zero(flat) ? Vec3d{0, 0, 1} : flat;
  }

 private:
  Vec3d in_file(const PolygonCorner& c) const {
    return c.normal == kNoIndex ? Vec3d{} : file_[c.normal];
  }

  const Vec3d& position(const Triangle& t, std::size_t i) const {
    return polygons_.positions[polygons_.corners[t[i % 3]].position];
  }

  /// The unit vectors from a triangle's corner to the next and to the previous one.
  std::array<Vec3d, 2> arms(const Triangle& t, std::size_t i) const {
    return {direction(position(t, i + 1) - position(t, i)),
            direction(position(t, i + 2) - position(t, i))};
  }

  Vec3d flat_normal(const Triangle& t) const {
    const auto [next, previous] = arms(t, 0);
    return direction(cross(next, previous));
  }

  /// Weighted by angles: G. Thürmer and C. A. Wüthrich, "Computing Vertex Normals from Polygonal
  /// Facets", 1998.
  void make_smooth(const CornerTriangles& triangles) {
    smooth_.resize(polygons_.positions.size());
    for (const Triangle& t : triangles) {
      const Vec3d normal = flat_normal(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [next, previous] = arms(t, i);
        const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
        Vec3d& sum = smooth_[polygons_.corners[t[i]].position];
        sum = sum + angle * normal;
      }
    }
    // Opposite faces cancel up to a few roundings of sums about 1.
    constexpr double kNothing = 1e-12;
    for (Vec3d& sum : smooth_) sum = length(sum) > kNothing ? normalize(sum) : Vec3d{};
  }

  const Polygons& polygons_;
  std::vector<Vec3d> file_, smooth_;
};

/// Collects vertices and gives equal ones one index.
class Vertices {
 public:
  explicit Vertices(std::size_t expected) : table_(expected) {}

  std::uint32_t index(const Vec3d& p, const Vec3d& n, const Vec2d& uv) {
    const auto is = [&](std::uint32_t i) {
      return mesh_.positions[i] == p && mesh_.normals[i] == n && mesh_.uvs[i] == uv;
    };
    const auto next = std::uint32_t(mesh_.positions.size());
    const std::uint64_t hash = hash_of({p.x, p.y, p.z, n.x, n.y, n.z, uv.u, uv.v});
    const std::uint32_t index = table_.find_or_add(hash, next, is);
    if (index == next) {
      mesh_.positions.push_back(p);
      mesh_.normals.push_back(n);
      mesh_.uvs.push_back(uv);
    }
    return index;
  }

  TriangleMesh take(Bulk<Triangle> triangles) {
    mesh_.triangles = std::move(triangles);
    return std::move(mesh_);
  }

 private:
  TriangleMesh mesh_;
  IndexTable table_;
};

}  // namespace

TriangleMesh triangulated(const Polygons& polygons, bool needs_uvs, std::string_view name) {
  check_sizes(polygons, name);
  if (needs_uvs) check_uvs(polygons, name);
  check_edges(polygons, name);
  CornerTriangles triangles = cut(polygons, name);
  const Normals normals(polygons, triangles);
  Vertices vertices(polygons.positions.size());
  for (Triangle& t : triangles) {
    const Triangle corners = t;
    for (std::size_t i = 0; i < 3; ++i) {
      const PolygonCorner& corner = polygons.corners[corners[i]];
      const Vec2d uv = corner.uv == kNoIndex ? Vec2d{} : polygons.uvs[corner.uv];
      t[i] =
          vertices.index(polygons.positions[corner.position], normals.of(corners[i], corners), uv);
    }
  }
  return vertices.take(std::move(triangles));
}

}  // namespace lumaknot
