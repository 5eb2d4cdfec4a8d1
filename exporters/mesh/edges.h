/// Whether polygons are a surface, of corners that exist.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "exporters/mesh/polygons.h"

namespace lumaknot {

/// Calls visit(polygon, corners) for each polygon, with the indices of its corners in
/// polygons.corners: of consecutive corners at one position only the first. Polygons left with
/// fewer than three are skipped.
template <class Visit>
void for_each_loop(const Polygons& polygons, Visit visit) {
  std::vector<std::uint32_t> loop;
  std::uint32_t first = 0;
  for (std::size_t polygon = 0; polygon < polygons.sizes.size(); ++polygon) {
    const auto position = [&](std::uint32_t i) { return polygons.corners[i].position; };
    loop.clear();
    for (std::uint32_t i = first; i < first + polygons.sizes[polygon]; ++i) {
      if (loop.empty() || position(loop.back()) != position(i)) loop.push_back(i);
    }
    while (loop.size() > 1 && position(loop.front()) == position(loop.back())) loop.pop_back();
    if (loop.size() >= 3) visit(polygon, std::span<const std::uint32_t>(loop));
    first += polygons.sizes[polygon];
  }
}

/// Throws Error at the first polygon with an edge that two others share, or that another uses in
/// the same direction.
void check_edges(const Polygons& polygons, std::string_view name);

/// Throws Error unless every corner's indices are within `polygons`.
void check_indices(const Polygons& polygons, std::string_view name);

}  // namespace lumaknot
