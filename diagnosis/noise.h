/// What is left of a picture that only noise sets apart from ours.
#pragma once

#include <optional>

#include "diagnosis/target.h"

namespace lumaknot::diagnosis {

/// The standard deviation of the difference of two pictures if it is white noise: its neighbours
/// are uncorrelated, it has no mean, neither as a whole nor in blocks of 8 x 8 pixels, and it is
/// no larger where the picture changes from pixel to pixel, as errors of filters and places are.
/// Of the pixels that both cover, for which `ours` and `theirs` must have every pixel.
std::optional<double> white_noise(const Target& theirs, const Drawn& ours);

}  // namespace lumaknot::diagnosis
