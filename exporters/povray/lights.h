/// Light sources of POV-Ray 3.7.
#pragma once

#include <string>

#include "scene/spec.h"

namespace lumaknot::povray {

/// Widest angle between the axis of POV-Ray's spot and the edge of its cone, degrees.
inline constexpr double kPovWidestSpot = 90;

/// Whether POV-Ray can attenuate light like this: by 2 / (1 + (d / distance)^power), one power.
inline bool has_pov_falloff(const Falloff& f) { return f.linear == 0 || f.quadratic == 0; }

/// The lights of `view` for a material of `space`, each colour times `tint`.
std::string pov_lights(const View& view, Space space, const Vec3d& tint);

}  // namespace lumaknot::povray
