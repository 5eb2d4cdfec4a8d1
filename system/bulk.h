/// Arrays of millions of plain values.
#pragma once

#include <sys/mman.h>

#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace lumaknot {

/// Leaves values that are not initialised as they are in memory, and asks the kernel for huge pages
/// where the array is large enough: the first write to a fresh page costs more than everything else
/// done to a mesh.
template <class T>
struct BulkAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  BulkAllocator() = default;
  template <class U>
  BulkAllocator(const BulkAllocator<U>&) {}  // converts, as allocators do

  T* allocate(std::size_t count) {
    if (count > std::size_t(-1) / 2 / sizeof(T)) throw std::bad_alloc();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kMin) return static_cast<T*>(::operator new(bytes));
    const std::size_t whole = (bytes + kHugePage - 1) / kHugePage * kHugePage;
    void* memory = std::aligned_alloc(kHugePage, whole);
    if (!memory) throw std::bad_alloc();
    ::madvise(memory, whole, MADV_HUGEPAGE);  // only a hint
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < kMin) {
      ::operator delete(memory);
    } else {
      std::free(memory);
    }
  }
  template <class U, class... Args>
  void construct(U* at, Args&&... args) {
    if constexpr (sizeof...(Args) > 0)
      ::new (static_cast<void*>(at)) U{std::forward<Args>(args)...};
  }
  friend bool operator==(const BulkAllocator&, const BulkAllocator&) { return true; }

 private:
  static constexpr std::size_t kHugePage = std::size_t(1) << 21;
  static constexpr std::size_t kMin = kHugePage / 4;  // 128 small faults cost more than a large one
};

/// A vector whose resize() writes nothing: every new element must be given a value before it is
/// read.
template <class T>
using Bulk = std::vector<T, BulkAllocator<T>>;

}  // namespace lumaknot
