/// How much a planned picture may differ from the truth.
#pragma once

namespace lumaknot::plan {

/// A pixel meets it if each channel, including coverage, is within `color` of the range that the
/// truth can have if each of its points is moved by at most `shift`: with one sample per pixel, the
/// range of what the truth shows within the shift of its centre; for means over pixels, from the
/// mean of each point's minimum to the mean of each point's maximum within the shift. No rasterised
/// picture meets a colour alone: at an edge, the thousandth of a pixel that corners are snapped to
/// turns black to white.
struct Tolerance {
  double color = 1.0 / 255;  ///< of the largest channel, > 0 and < 1, as colours are in [0, 1]
  double shift = 0.25;       ///< pixels, >= 0; 0: every colour at its exact place
  double in_place = 0;       ///< share of the pixels that must be within `color` without the shift
};

/// The accuracy of the truth itself, the limit of any tolerance: for pixels' centres, and for means
/// over pixels.
inline constexpr double kPointTruthError = 1e-8, kAreaTruthError = 1e-4;

/// Throws Error, naming --tolerance or --shift, unless a picture can be checked against it.
void check_tolerance(const Tolerance& tolerance, bool area);

}  // namespace lumaknot::plan
