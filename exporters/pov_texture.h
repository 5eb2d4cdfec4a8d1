/// Textures of POV-Ray 3.7 whose sum is a lit colour.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/shot.h"

namespace lumaknot {

/// Names of the image files.
std::string pov_texture_name(const std::string& prefix);
std::string pov_luma_name(const std::string& prefix, Space space);

/// Highlights are `weight` times the light's colour, since POV-Ray tints them by nothing else; so
/// the lights are tinted for them, and the diffuse term the other way.
struct PovHighlight {
  Vec3d tint{1, 1, 1};  ///< of the lights
  double weight = 0;
};

/// The highlight of `shot`, or nothing where a channel without highlights has a diffuse term.
std::optional<PovHighlight> pov_highlight(const View& view, const Shot& shot);

/// What `shot` needs declared before its texture, and the texture itself.
struct PovTexture {
  std::string declarations, texture;
};

PovTexture pov_texture(const View& view, const Texture& texture, const Shot& shot,
                       const std::string& prefix);

}  // namespace lumaknot
