/// Many items formatted on all cores and written in order.
#pragma once

#include <cstddef>
#include <functional>
#include <ostream>

namespace lumaknot {

/// Puts the items [first, last) at `at`, which has room for them, and returns their end. Called on
/// several threads at once.
using RangeFormat = std::function<char*(std::size_t first, std::size_t last, char* at)>;

/// Writes the items [0, count) in order, none longer than `item_bytes`. The bytes do not depend on
/// the number of threads, and memory is a few MiB at most. Stops early when `stream` fails.
void write_ranges(std::ostream& stream, std::size_t count, std::size_t item_bytes,
                  const RangeFormat& format);

/// The same with `format(index, at)`, which puts one item at `at` and returns its end.
template <class Format>
void write_items(std::ostream& stream, std::size_t count, std::size_t item_bytes,
                 const Format& format) {
  write_ranges(stream, count, item_bytes, [&](std::size_t first, std::size_t last, char* at) {
    for (std::size_t i = first; i < last; ++i) at = format(i, at);
    return at;
  });
}

}  // namespace lumaknot
