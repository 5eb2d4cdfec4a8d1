/// Lighting formulas as recorded graphs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/shot.h"
#include "shaders/graph/expression.h"

namespace lumaknot {

/// A value that the vertex stage computes and the fragment stage reads interpolated.
struct Varying {
  std::string name;
  NodePtr value;
};

/// A shot as graphs. The inputs are position and normal, both world, and texture, the r'g'b' of the
/// texture, or texture_axes, its values on the axes of the space, with Form::kBaked. With
/// ShadingFrequency::kVertex the light is in `varyings`, which `color` reads as inputs.
struct Recorded {
  std::vector<Varying> varyings;
  NodePtr color;
};

/// Which numbers of the scene stay adjustable by the user.
enum class Keep {
  kNeeded,  ///< all except those that are 0 or 1 now: what this scene does not need is omitted
  kAll
};

/// The formula of `shot`, with the numbers of the scene as named parameters. With `color`, the
/// r'g'b' of a surface without a texture, that is a parameter too: base_color or base_axes.
Recorded record_shot(const View& view, const Shot& shot, Keep keep = Keep::kNeeded,
                     const std::optional<Vec3d>& color = std::nullopt);

}  // namespace lumaknot
