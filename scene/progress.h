/// How far a long computation is.
#pragma once

#include <functional>

namespace lumaknot {

/// Called with the finished share in [0, 1], rising; from any thread, one call at a time.
using Progress = std::function<void(double)>;

}  // namespace lumaknot
