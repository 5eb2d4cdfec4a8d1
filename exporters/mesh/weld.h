/// Merging vertices with equal positions, for formats that index positions separately.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lumaknot {

/// The position index of each vertex: a seam's copies share theirs.
struct Weld {
  std::vector<std::uint32_t> position;  ///< of each vertex, numbered from 0 by first use
  std::vector<bool> repeats;            ///< whether an earlier vertex has that position
  std::uint32_t count = 0;              ///< number of distinct positions
};

/// Merges positions that are equal in float32, 0 and -0 included. Uses at most 10 bytes per vertex,
/// and keeps 4 of them.
Weld weld(std::span<const Vec3d> positions);

}  // namespace lumaknot
