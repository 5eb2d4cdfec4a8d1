/// What section 3 claims of Table 1's listing.
#pragma once

#include <optional>
#include <vector>

#include "scene/image.h"
#include "study/paper/claim.h"
#include "study/paper/paper_scenes.h"
#include "validate/renderer.h"

namespace lumaknot {

/// The listing and its equations, and its equations with one thing of the listing's.
struct ListingPictures {
  Image equations, listing, offset, clamps, normal;
};

PaperClaim listing_claim(const ListingPictures& pictures);
PaperClaim offset_claim(const ListingPictures& pictures);
PaperClaim clamps_claim(const ListingPictures& pictures);
PaperClaim normal_claim(const ListingPictures& pictures);

/// Pixels of a front and a back light where L_D is 0 and L_S more than a step.
PaperClaim gate_claim(long long front, long long back);

/// What the default exponent, which the slider cannot reach, and the slider's most draw.
struct SliderPictures {
  double slider_most, initial;
  Image at_most, at_default;
};
PaperClaim slider_claim(const SliderPictures& pictures);

PaperClaim slots_claim(int pixel_slots, int vertex_slots);

/// SPIR-V instructions of the same formula from HLSL and from GLSL; none without the compiler.
PaperClaim glsl_claim(std::optional<int> hlsl, std::optional<int> glsl);

std::vector<PaperClaim> listing_claims(const PaperScenes& scenes, const Programs& programs);

}  // namespace lumaknot
