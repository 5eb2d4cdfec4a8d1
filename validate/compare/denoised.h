/// What a denoiser made of noisy pictures.
#pragma once

#include <string>

#include "validate/compare/noise.h"

namespace lumaknot::validate {

/// Errors against the expectation, of the channel of colour with most: root mean square over the
/// pixels that ours covers in part. There is no verdict: a denoiser leaves a bias that no count of
/// samples removes.
struct DenoisedErrors {
  double noisy = 0, denoised = 0;  ///< of one picture
  double bias = 0;   ///< the part that both denoised pictures share: noise does not count
  double whole = 0;  ///< the bias of the picture's mean, background included
};

/// `first` and `second` are the pair's pictures, denoised.
DenoisedErrors denoised_errors(const NoisyPair& pair, const Image& first, const Image& second);

/// "denoised, an error of 0.0087 per pixel, 0.0048 before; 0.0066 of it is a bias".
std::string denoised_text(const DenoisedErrors& errors);

}  // namespace lumaknot::validate
