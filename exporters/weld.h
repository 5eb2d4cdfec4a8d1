/// Vertices with one position made one again, for formats that index positions apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/vec.h"

namespace lumaknot {

/// Which position each vertex has: a seam's copies share theirs.
struct Weld {
  std::vector<std::uint32_t> position;  ///< of each vertex, numbered by first use from 0
  std::vector<bool> repeats;            ///< whether an earlier vertex has that position
  std::uint32_t count = 0;              ///< positions that differ
};

/// Welds what is equal in float32; 0 and -0 are. At most 10 bytes a vertex are in use, 4 of them
/// kept.
Weld weld(std::span<const Vec3d> positions);

}  // namespace lumaknot
