/// Eq. 1 and 2 as the paper's text and print have them, errors and all: for its own examination
/// alone. The formulas that pictures are made of are in shaders/terms.h.
#pragma once

#include <algorithm>

#include "scene/vec.h"

namespace lumaknot {

/// What eq. 1 and 2 speak of, unit vectors: the normal, from the surface to the light and to the
/// eye.
struct PrintedDirections {
  Vec3d n, l, v;
};

/// Eq. 1 with L "pointing from the light source to the surface", as the text defines it.
inline double eq1_as_worded(const PrintedDirections& d) { return std::max(dot(-d.l, d.n), 0.0); }

/// Eq. 2 as printed, v . (L - (2 L . n)): a vector less a number, which HLSL takes from each of its
/// components; no exponent. L from the surface to the light, as in Table 1.
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

}  // namespace lumaknot
