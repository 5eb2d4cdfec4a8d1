/// Failures that are not the job's fault.
#pragma once

#include <stdexcept>

namespace lumaknot::gpu {

/// A missing API or driver, or a shader that it rejects. The last line of the message says what; a
/// compiler's log may precede it.
struct Unavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lumaknot::gpu
