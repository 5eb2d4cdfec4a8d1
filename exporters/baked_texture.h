/// Textures that hold the axes of a space in place of r'g'b'.
#pragma once

#include "scene/scene.h"

namespace lumaknot {

/// `texture` on the axes of the material's space: brightness and the two of chroma.
TextureImage baked_texture(const TextureImage& texture, const Material& material);

}  // namespace lumaknot
