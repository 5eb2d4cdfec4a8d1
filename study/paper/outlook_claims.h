/// The claims of section 6 about other lighting models and other spaces.
#pragma once

#include <string>
#include <vector>

#include "study/paper/claim.h"
#include "study/paper/formula_times.h"
#include "study/paper/picture_measures.h"
#include "study/paper/scenes.h"

namespace lumaknot::paper {

/// Minnaert's model without highlights.
PaperClaim minnaert_claim(const Image& texture, const Image& rgb, const Image& yiq);

/// A lighting model's pictures with the light at the back.
struct ModelPictures {
  std::string name;
  Image rgb, yiq;
};
PaperClaim models_claim(const Image& texture, const std::vector<ModelPictures>& models);

/// The back picture with light on the brightness of a space.
struct SpacePicture {
  std::string name;
  Image image;
  int slots = 0;  ///< of the pixel shader
};
PaperClaim spaces_claim(const std::vector<SpacePicture>& spaces);
PaperClaim slow_spaces_claim(const std::vector<FormulaTime>& times);

/// `spaces` hold yiq, din99 and atd95; the mean hue is taken where `shadow` says.
PaperClaim perceptual_claim(const Image& texture, const std::vector<SpacePicture>& spaces,
                            const Marks& shadow);

/// Pictures of one light; `real` computed on linear light.
struct RealPictures {
  Image real, phong, yiq;
};
PaperClaim realism_claim(const RealPictures& front, const RealPictures& back);

PaperClaim complex_scenes_claim(double flip_near, double flip_far);

std::vector<PaperClaim> outlook_claims(const PaperScenes& scenes,
                                       const std::vector<FormulaTime>& times);

}  // namespace lumaknot::paper
