#include "exporters/mesh/edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "exporters/text/scanner.h"

namespace lumaknot {
namespace {

/// A polygon's edge, stored with the position that it starts from.
struct Edge {
  std::uint32_t to = 0, polygon = 0;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// The edges of all polygons, sorted by start and end: those from position p are edges[begin[p]] up
/// to edges[begin[p + 1]].
struct Edges {
  std::vector<std::uint32_t> begin;
  std::vector<Edge> edges;

  std::span<const Edge> from(std::uint32_t position) const {
    return std::span(edges).subspan(begin[position], begin[position + 1] - begin[position]);
  }
};

template <class Visit>
void for_each_edge(const Polygons& polygons, Visit visit) {
  for_each_loop(polygons, [&](std::size_t polygon, std::span<const std::uint32_t> loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      visit(polygons.corners[loop[i]].position,
            Edge{polygons.corners[loop[(i + 1) % loop.size()]].position, std::uint32_t(polygon)});
    }
  });
}

Edges edges_of(const Polygons& polygons) {
  Edges result;
  result.begin.resize(polygons.positions.size() + 2);
  for_each_edge(polygons, [&](std::uint32_t from, const Edge&) { ++result.begin[from + 2]; });
  for (std::size_t i = 2; i < result.begin.size(); ++i) result.begin[i] += result.begin[i - 1];
  result.edges.resize(result.begin.back());
  // begin[p + 1] is where the next edge from p goes, and finally the begin of p + 1.
  for_each_edge(polygons, [&](std::uint32_t from, const Edge& edge) {
    result.edges[result.begin[from + 1]++] = edge;
  });
  for (std::uint32_t p = 0; p < polygons.positions.size(); ++p) {
    std::sort(result.edges.begin() + result.begin[p], result.edges.begin() + result.begin[p + 1]);
  }
  return result;
}

/// Two polygons with an edge in the same direction.
struct Clash {
  std::uint32_t from, to, first, second;
};

std::optional<Clash> first_clash(const Edges& edges, std::size_t positions) {
  std::optional<Clash> found;
  for (std::uint32_t p = 0; p < positions; ++p) {
    const std::span<const Edge> from = edges.from(p);
    for (std::size_t i = 1; i < from.size(); ++i) {
      if (from[i].to != from[i - 1].to) continue;
      if (found && found->second <= from[i].polygon) continue;
      found = Clash{p, from[i].to, from[i - 1].polygon, from[i].polygon};
    }
  }
  return found;
}

std::string vertex_text(const Polygons& polygons, std::uint32_t i) {
  const Vec3d& p = polygons.positions[i];
  return fmt::format("{} ({:.6g}, {:.6g}, {:.6g})", std::uint64_t(i) + polygons.first_index, p.x,
                     p.y, p.z);
}

[[noreturn]] void refuse(const Polygons& polygons, const Edges& edges, const Clash& clash,
                         std::string_view name) {
  const std::span<const Edge> back = edges.from(clash.to);
  const auto opposite = std::ranges::find(back, clash.from, &Edge::to);
  const std::string others = fmt::format("of {} {}", polygons.unit, polygons.places[clash.first]);
  const std::string why = opposite != back.end()
                              ? fmt::format("a third face, with those {} and {}", others,
                                            polygons.places[opposite->polygon])
                              : fmt::format("a face in the same direction as that {}", others);
  throw file_error(
      name, polygons.unit, polygons.places[clash.second],
      fmt::format("{} at the edge of vertices {} and {}: no surface; make it manifold, "
                  "with all faces turned outwards",
                  why, vertex_text(polygons, clash.from), vertex_text(polygons, clash.to)));
}

}  // namespace

void check_edges(const Polygons& polygons, std::string_view name) {
  const Edges edges = edges_of(polygons);
  if (const auto clash = first_clash(edges, polygons.positions.size())) {
    refuse(polygons, edges, *clash, name);
  }
}

void check_indices(const Polygons& polygons, std::string_view name) {
  std::size_t at = 0;
  for (std::size_t polygon = 0; polygon < polygons.sizes.size(); ++polygon) {
    const auto check = [&](std::uint32_t index, std::size_t size, std::string_view what) {
      if (index < size || (index == kNoIndex && what != "vertex")) return;
      const std::uint64_t base = polygons.first_index;
      throw file_error(name, polygons.unit, polygons.places[polygon],
                       fmt::format("{} {} does not exist, the file has {}, from {} on; {}", what,
                                   index + base, size, base, kExportAgain));
    };
    for (std::uint32_t i = 0; i < polygons.sizes[polygon]; ++i, ++at) {
      const PolygonCorner& corner = polygons.corners[at];
      check(corner.position, polygons.positions.size(), "vertex");
      check(corner.normal, polygons.normals.size(), "normal");
      check(corner.uv, polygons.uvs.size(), "texture coordinate");
    }
  }
}

}  // namespace lumaknot
