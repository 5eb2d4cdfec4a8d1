/// Bad input, reported in one line: where, what, the remedy.
#pragma once

#include <stdexcept>

namespace lumaknot {

/// Wrong use or bad input. The message names the flag or the JSON path, the value and the remedy.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lumaknot
