/// Eq. 1 and 2 as printed in the paper, including errors: only for its examination. The formulas
/// that pictures use are in shaders/formulas/terms.h.
#pragma once

#include <algorithm>

#include "math/vec.h"

namespace lumaknot::paper {

/// The unit vectors of eq. 1 and 2: the normal, from the surface to the light and to the
/// eye.
struct PrintedDirections {
  Vec3d n, l, v;
};

/// Eq. 1 with L "pointing from the light source to the surface", as the text defines it.
inline double eq1_as_worded(const PrintedDirections& d) { return std::max(dot(-d.l, d.n), 0.0); }

/// Eq. 2 as printed, v . (L - (2 L . n)): a vector minus a number, which HLSL subtracts from each
/// of its components; no exponent. L from the surface to the light, as in Table 1.
inline double eq2_as_printed(const PrintedDirections& d) {
  const double number = 2 * dot(d.l, d.n);
  return std::max(dot(d.v, d.l - Vec3d{number, number, number}), 0.0);
}

/// Eq. 2 with the missing n put back, v . (L - 2 (L . n) n), and L as the text defines it, from the
/// light to the surface. The exponent is still missing.
inline double eq2_with_n(const PrintedDirections& d) {
  const Vec3d from_light = -d.l;
  return std::max(dot(d.v, from_light - d.n * (2 * dot(from_light, d.n))), 0.0);
}

}  // namespace lumaknot::paper
