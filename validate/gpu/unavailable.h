/// What the job can't be blamed for.
#pragma once

#include <stdexcept>

namespace lumaknot::gpu {

/// An API or driver that can't be had, or a shader that it refuses. The last line of the message
/// says what; a compiler's log may stand before it.
struct Unavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lumaknot::gpu
