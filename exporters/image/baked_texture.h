/// Textures that hold the axes of a space instead of r'g'b'.
#pragma once

#include "scene/spec.h"

namespace lumaknot {

/// `texture` on the axes of the material's space: brightness and two of chroma.
TextureImage baked_texture(const TextureImage& texture, const Material& material);

}  // namespace lumaknot
