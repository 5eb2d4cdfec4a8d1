/// A test of noisy pictures in words.
#pragma once

#include <string>

#include "validate/compare/noise.h"

namespace lumaknot::validate {

/// "a pixel", "16 x 16 pixels" or "the whole picture".
std::string scale_name(const NoiseTest& test, std::size_t scale);

/// "22 blocks of 16 x 16 pixels, most at (64, 176): red is 0.0035 above ours, 0.0003 admitted".
std::string finding_text(const NoiseTest& test, std::size_t scale);

/// The scale that uses the largest share of what is admitted.
std::size_t worst_scale(const NoiseTest& test);

}  // namespace lumaknot::validate
