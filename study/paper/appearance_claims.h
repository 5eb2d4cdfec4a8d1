/// The claims of section 4 about Figure 1's pictures.
#pragma once

#include <vector>

#include "scene/image.h"
#include "study/paper/claim.h"
#include "study/paper/picture_measures.h"
#include "study/paper/scenes.h"

namespace lumaknot::paper {

/// One light's pictures in both techniques, with where its light falls.
struct LookPictures {
  Image texture, phong, yiq;
  Marks shadow;     ///< L_D is 0
  Marks highlight;  ///< L_S is at least 0.1
  Marks unlit;      ///< L_S is no more than a step
};

PaperClaim front_similar_claim(const LookPictures& front);
PaperClaim no_worse_claim(const LookPictures& front);
PaperClaim phong_back_claim(const LookPictures& back);
PaperClaim yiq_back_claim(const LookPictures& back);

/// Specular reflection only, on one texture after the other.
PaperClaim phong_grey_claim(const std::vector<Image>& phong);
PaperClaim yiq_keeps_claim(const LookPictures& specular);

/// `metal`: the highlight in the texture's own colour.
PaperClaim metal_claim(const LookPictures& specular, const Image& metal);

/// The YIQ pictures of one light from all around, and their texture.
struct View360 {
  Image texture, yiq;
};
PaperClaim any_angle_claim(const std::vector<View360>& views);

std::vector<PaperClaim> look_claims(const PaperScenes& scenes);

}  // namespace lumaknot::paper
