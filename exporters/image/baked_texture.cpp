#include "exporters/image/baked_texture.h"

#include <algorithm>

#include "shaders/formulas/lighting.h"

namespace lumaknot {

TextureImage baked_texture(const TextureImage& texture, const Material& material) {
  TextureImage baked = texture;
  std::ranges::transform(baked.pixels, baked.pixels.begin(), [&](const Rgb& rgb) {
    return to_rgb(texture_value(to_vec(rgb), material));
  });
  return baked;
}

}  // namespace lumaknot
