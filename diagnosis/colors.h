/// What may be done to colours.
#pragma once

#include <span>

#include "diagnosis/setup.h"

namespace lumaknot::diagnosis {

/// |c|^exponent with the sign of c, per channel.
Vec3d powered(const Vec3d& color, double exponent);

/// The curve of each channel, odd below zero.
Vec3d curved(Curve curve, const Vec3d& color);

Vec3d permuted(const std::array<std::size_t, 3>& channels, const Vec3d& color);

/// Between the grey of its luma (0), itself (1) and beyond.
Vec3d saturated(const Vec3d& color, double saturation);

/// Applies all of `use` to each pixel.
void apply(const ColorUse& use, std::span<Vec3d> colors, std::span<const double> coverage);

}  // namespace lumaknot::diagnosis
