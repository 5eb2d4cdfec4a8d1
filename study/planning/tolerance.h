/// What a planned picture may differ by from the truth.
#pragma once

namespace lumaknot {

/// A pixel meets it when each channel, coverage among them, lies within `color` of the range that
/// the truth can have when every point of it is moved by at most `shift`: of one sample a pixel, of
/// what the truth shows within the shift of its centre; of means over pixels, from the mean of each
/// point's least to the mean of each point's most within the shift. A colour alone no rasterised
/// picture meets: at an edge, the thousandth of a pixel that corners are snapped to turns black to
/// white.
struct Tolerance {
  double color = 1.0 / 255;  ///< of the largest channel, > 0 and < 1, as colours are in [0, 1]
  double shift = 0.25;       ///< pixels, >= 0; 0: every colour at its very place
};

/// What the truth itself is known to, which no tolerance may be finer than: of pixels' centres, and
/// of means over pixels.
inline constexpr double kPointTruthError = 1e-8, kAreaTruthError = 1e-4;

/// Throws Error, naming --tolerance or --shift, unless a picture can be held to it.
void check_tolerance(const Tolerance& tolerance, bool area);

}  // namespace lumaknot
