/// Values in POV-Ray's scene description language.
#pragma once

#include <fmt/format.h>

#include <string>

#include "math/vec.h"

namespace lumaknot::povray {

inline std::string pov_vector(const Vec3d& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); }

inline bool is_grey(const Vec3d& color) { return color.x == color.y && color.y == color.z; }

/// A colour, linear: POV-Ray's gamma is off.
inline std::string pov_color(const Vec3d& color) {
  return is_grey(color) ? fmt::format("rgb {}", color.x) : "rgb " + pov_vector(color);
}

}  // namespace lumaknot::povray
