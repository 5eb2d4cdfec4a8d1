/// Values that may be absent in general, but not where they are asked for.
#pragma once

#include <optional>
#include <stdexcept>
#include <utility>

namespace lumaknot {

/// What `value` holds. Throws std::logic_error if it is empty, which only a mistake in the program
/// can be the reason of.
template <class T>
T known(std::optional<T> value) {
  if (!value) throw std::logic_error("a value is missing that must be there");
  return *std::move(value);
}

}  // namespace lumaknot
