/// The progress of a long computation.
#pragma once

#include <functional>

namespace lumaknot {

/// Called with the finished share in [0, 1], increasing; from any thread, one call at a time.
using Progress = std::function<void(double)>;

}  // namespace lumaknot
