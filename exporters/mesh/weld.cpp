// A hash table with linear probing that stores only vertex indices.
#include "exporters/mesh/weld.h"

#include <bit>
#include <limits>

namespace lumaknot {
namespace {

using Position = Vec3<float>;

constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();

/// In float32, ignoring the sign of zero.
Position narrowed(const Vec3d& p) { return {float(p.x) + 0.f, float(p.y) + 0.f, float(p.z) + 0.f}; }

/// 32 well-mixed bits: the finaliser of MurmurHash3 (A. Appleby) over a sum with odd factors.
std::uint64_t hash(const Position& p) {
  std::uint64_t bits = std::bit_cast<std::uint32_t>(p.x) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ bits >> 32 ^ std::bit_cast<std::uint32_t>(p.y)) * 0xff51afd7ed558ccdu;
  bits = (bits ^ bits >> 32 ^ std::bit_cast<std::uint32_t>(p.z)) * 0xc4ceb9fe1a85ec53u;
  return (bits ^ bits >> 33) * 0xff51afd7ed558ccdu >> 32;
}

/// The first vertex with the position of vertex `index`, which is put in `table` if it is the
/// first.
std::uint32_t first_alike(std::span<const Vec3d> positions, std::uint32_t index,
                          std::vector<std::uint32_t>& table) {
  const Position position = narrowed(positions[index]);
  std::size_t slot = hash(position) * table.size() >> 32;
  for (; table[slot] != kEmpty; slot = slot + 1 == table.size() ? 0 : slot + 1) {
    if (narrowed(positions[table[slot]]) == position) return table[slot];
  }
  return table[slot] = index;
}

}  // namespace

Weld weld(std::span<const Vec3d> positions) {
  Weld weld;
  weld.position.resize(positions.size());
  weld.repeats.resize(positions.size());
  std::vector<std::uint32_t> table(positions.size() + positions.size() / 2 + 1, kEmpty);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t first = first_alike(positions, i, table);
    weld.repeats[i] = first != i;
    weld.position[i] = first == i ? weld.count++ : weld.position[first];
  }
  return weld;
}

}  // namespace lumaknot
