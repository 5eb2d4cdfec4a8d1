/// Textures of POV-Ray 3.7 whose sum is a lit colour.
#pragma once

#include <optional>
#include <string>

#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::povray {

/// How POV-Ray draws the terms of the material's model.
PovTerm diffuse_in_pov(const Material& material);
PovTerm highlight_in_pov(const Material& material);

/// Names of the image files.
std::string pov_texture_name(const std::string& prefix);
std::string pov_luma_name(const std::string& prefix, Space space);

/// Highlights are `weight` times the light's colour, since POV-Ray tints them by nothing else; so
/// the lights are tinted for them, and the diffuse term inversely.
struct PovHighlight {
  Vec3d tint{1, 1, 1};  ///< of the lights
  double weight = 0;
};

/// The highlight of `shot`; empty where a channel without highlights has a diffuse term.
std::optional<PovHighlight> pov_highlight(const View& view, const Shot& shot);

/// The same, of a shot for which it is not empty. Throws std::logic_error if it is.
PovHighlight drawn_highlight(const View& view, const Shot& shot);

/// The declarations that `shot` needs before its texture, and the texture itself.
struct PovTexture {
  std::string declarations, texture;
};

PovTexture pov_texture(const View& view, const Texture& texture, const Shot& shot,
                       const std::string& prefix);

}  // namespace lumaknot::povray
