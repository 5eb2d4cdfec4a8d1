/// Finds equal values by their hash.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace lumaknot {

/// A hash of numbers in which -0 equals 0, as for ==. After splitmix64's mixing.
inline std::uint64_t hash_of(std::initializer_list<double> numbers) {
  std::uint64_t hash = 0;
  for (const double number : numbers) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  hash *= 0xbf58476d1ce4e5b9u;
  return hash ^ (hash >> 32);
}

/// Indices below 2^32 - 1 of values that are stored elsewhere: open addressing with linear probing.
class IndexTable {
 public:
  /// Room for about `values` without growing.
  explicit IndexTable(std::size_t values) : slots_(std::bit_ceil(2 * values + 16)) {}

  /// The index for which `is(index)` holds among those with this hash; if there is none, `next`,
  /// which is stored.
  template <class Is>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t next, Is is) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    const auto key = std::uint32_t(hash);
    std::size_t at = key & (slots_.size() - 1);
    for (; slots_[at].index != kFree; at = (at + 1) & (slots_.size() - 1)) {
      if (slots_[at].key == key && is(slots_[at].index)) return slots_[at].index;
    }
    slots_[at] = {key, next};
    ++used_;
    return next;
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t(0);
  struct Slot {
    std::uint32_t key = 0;
    std::uint32_t index = kFree;
  };

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    for (const Slot& slot : old) {
      if (slot.index == kFree) continue;
      std::size_t at = slot.key & (slots_.size() - 1);
      while (slots_[at].index != kFree) at = (at + 1) & (slots_.size() - 1);
      slots_[at] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace lumaknot
