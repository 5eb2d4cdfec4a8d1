/// Signs that rounding can't flip.
#pragma once

#include "math/vec.h"

namespace lumaknot {

/// The sign (-1, 0, 1) of a . (b x c) for the doubles as they are, in exact arithmetic.
int exact_volume_sign(const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace lumaknot
