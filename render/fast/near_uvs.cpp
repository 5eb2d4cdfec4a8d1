#include "render/fast/near_uvs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace lumaknot::fast {
namespace {

using Tile = std::array<double, 2>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The tile where the triangle's coordinates begin; zero where they are not finite.
Tile tile_of(const TriangleMesh& mesh, const Triangle& triangle) {
  const Vec2d &a = mesh.uvs[triangle[0]], &b = mesh.uvs[triangle[1]], &c = mesh.uvs[triangle[2]];
  if (!std::isfinite(a.u + b.u + c.u + a.v + b.v + c.v)) return {0, 0};
  return {std::floor(std::min({a.u, b.u, c.u})), std::floor(std::min({a.v, b.v, c.v}))};
}

/// The corners being built.
class Corners {
 public:
  explicit Corners(const TriangleMesh& mesh)
      : mesh_(mesh), tiles_(mesh.uvs.size(), {kNone, kNone}) {
    result_.vertices.resize(mesh.uvs.size());
    std::iota(result_.vertices.begin(), result_.vertices.end(), std::uint32_t{0});
    result_.uvs = {mesh.uvs.begin(), mesh.uvs.end()};
    result_.triangles.reserve(mesh.triangles.size());
  }

  NearUvs all() {
    for (const Triangle& t : mesh_.triangles) {
      const Tile tile = tile_of(mesh_, t);
      result_.triangles.push_back({corner(t[0], tile), corner(t[1], tile), corner(t[2], tile)});
    }
    return std::move(result_);
  }

 private:
  std::uint32_t corner(std::uint32_t vertex, const Tile& tile) {
    if (std::isnan(tiles_[vertex][0])) {
      tiles_[vertex] = tile;
      result_.uvs[vertex] = less(vertex, tile);
    }
    if (tiles_[vertex] == tile) return vertex;
    const auto [at, is_new] =
        others_.try_emplace({vertex, tile}, std::uint32_t(result_.vertices.size()));
    if (is_new) {
      result_.vertices.push_back(vertex);
      result_.uvs.push_back(less(vertex, tile));
    }
    return at->second;
  }

  Vec2d less(std::uint32_t vertex, const Tile& tile) const {
    const Vec2d& uv = mesh_.uvs[vertex];
    return {uv.u - tile[0], uv.v - tile[1]};
  }

  const TriangleMesh& mesh_;
  std::vector<Tile> tiles_;  ///< of each vertex's own corner; kNone before its first triangle
  std::map<std::pair<std::uint32_t, Tile>, std::uint32_t> others_;
  NearUvs result_;
};

}  // namespace

NearUvs near_uvs(const TriangleMesh& mesh) { return Corners(mesh).all(); }

}  // namespace lumaknot::fast
