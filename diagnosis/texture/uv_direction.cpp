/// Texture coordinates flipped or exchanged.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> uv_direction(const Situation& situation) {
  if (!has_image(situation)) return {};
  const auto flipped = [](std::string id, std::string sentence, bool u, bool v) {
    return discrete(std::move(id), Rung::kTexture, std::move(sentence), [u, v](Setup& s) {
      TextureUse& use = s.texturing;
      if (u) use.u_scale *= -1, use.u_offset = 1 - use.u_offset;
      if (v) use.v_scale *= -1, use.v_offset = 1 - use.v_offset;
    });
  };
  return {flipped("texture-flip-v", "the texture's V flipped", false, true),
          flipped("texture-flip-u", "the texture's U flipped", true, false),
          flipped("texture-flip-uv", "the texture's U and V flipped", true, true),
          discrete("texture-uv-exchanged", Rung::kTexture, "the texture's U and V exchanged",
                   [](Setup& s) { s.texturing.swapped = true; })};
}

}  // namespace lumaknot::diagnosis
