/// The colour difference CIEDE2000: G. Sharma, W. Wu and E. Dalal, "The CIEDE2000 color-difference
/// formula: implementation notes, supplementary test data, and mathematical observations", Color
/// Research and Application 30, 2005.
#pragma once

#include "shaders/spaces/cielab.h"

namespace lumaknot::measure {

/// Delta E 2000 of two colours, k_L = k_C = k_H = 1: about 1 is just seen. Symmetric.
double ciede2000(const Lab<double>& first, const Lab<double>& second);

}  // namespace lumaknot::measure
