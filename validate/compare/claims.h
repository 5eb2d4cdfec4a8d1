/// The paper's claims about Figure 1, as numbers measured on a picture.
#pragma once

#include "scene/image.h"

namespace lumaknot::validate {

/// Phong "completely grey", YIQ "keeps the surface's colour": how much colour highlights keep, how
/// far hues move, and how much is lost by limiting to [0, 1].
struct Claims {
  long long highlight_pixels = 0;  ///< where the specular term is at least 0.1
  double highlight_chroma = 0;     ///< their mean chroma, max(r,g,b) - min(r,g,b); 0 is grey
  double hue_shift_degrees = 0;    ///< mean angle in the I-Q plane between picture and texture,
                                   ///< over pixels that have a hue in both
  double clipped_at_zero = 0;      ///< share of covered pixels with a channel at or below 0
  double clipped_at_one = 0;       ///< share of covered pixels with a channel at or above 1
};

/// From a final image, and our own images of the same scene's texture and specular stages.
Claims measure_claims(const Image& final, const Image& texture, const Image& specular);

}  // namespace lumaknot::validate
