/// The claims of section 3 about Table 1's listing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/image.h"
#include "study/paper/claim.h"
#include "study/paper/scenes.h"

namespace lumaknot::paper {

/// The listing and its equations, and its equations with one thing of the listing's.
struct ListingPictures {
  Image equations, listing, offset, clamps, normal;
};

PaperClaim listing_claim(const ListingPictures& pictures);
PaperClaim offset_claim(const ListingPictures& pictures);
PaperClaim clamps_claim(const ListingPictures& pictures);
PaperClaim normal_claim(const ListingPictures& pictures);

/// Pixels of a picture where L_D is 0 and L_S more than a step.
struct Ungated {
  std::string picture;
  long long pixels = 0;
};
PaperClaim gate_claim(const std::vector<Ungated>& pictures);

/// Pictures by the default exponent, which the slider cannot reach, and by the slider's maximum.
struct SliderPictures {
  double slider_max, initial;
  Image at_most, at_default;
};
PaperClaim slider_claim(const SliderPictures& pictures);

PaperClaim slots_claim(int pixel_slots, int vertex_slots);

/// The formula's function in both languages.
PaperClaim glsl_claim(const std::string& hlsl, const std::string& glsl);

/// The listing's text as printed in both scans.
PaperClaim ready_claim(std::string_view text);

std::vector<PaperClaim> listing_claims(const PaperScenes& scenes);

}  // namespace lumaknot::paper
