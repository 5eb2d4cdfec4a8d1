/// Measures of pictures. Pixels that no surface covers never count; unless stated otherwise,
/// colours are those of a display, limited to [0, 1].
#pragma once

#include <functional>
#include <vector>

#include "scene/image.h"

namespace lumaknot::paper {

/// A step of an 8-bit display: smaller differences look the same there.
inline constexpr double kStep = 1.0 / 255;

/// A mark per pixel of an image.
using Marks = std::vector<char>;

/// The covered pixels whose first channel `is_in`, in a picture of a stage.
Marks marked(const Image& stage, const std::function<bool(double)>& is_in);
Marks both(const Marks& a, const Marks& b);
double share_marked(const Marks& marks, const Image& image);  ///< of the covered pixels

/// How far two pictures are apart, by the largest difference of a pixel's channels.
struct Change {
  double share = 0;      ///< of covered pixels: more than a step
  long long pixels = 0;  ///< their number
  double mean = 0, max = 0;
};
Change change_between(const Image& a, const Image& b);
Change change_between(const Image& a, const Image& b, const Marks& where);

/// The same of colours as computed, whether a display can show them or not.
Change unlimited_change(const Image& a, const Image& b);

/// The largest difference of two channels of one pixel, not limited: 0 if all is grey.
double largest_tint(const Image& image);

/// `a` - `b`, not limited.
Image minus(const Image& a, const Image& b);

/// CIELAB of displayed colours: chroma C*, its mean over the marked pixels; saturation C* / L*, the
/// mean chroma over the mean lightness. 0 if nothing is marked.
double mean_chroma(const Image& image, const Marks& where);
double mean_lightness(const Image& image, const Marks& where);
double saturation(const Image& image, const Marks& where);

/// The mean angle between the CIELAB hues of two pictures, degrees; over the marked pixels whose
/// chroma is at least 2 in both.
double mean_hue_turn(const Image& a, const Image& b, const Marks& where);

/// The rise of luma (eq. 4) above the other picture's.
struct Rise {
  double share = 0;  ///< of covered pixels: by more than a step
  double max = 0;
};
Rise luma_rise(const Image& image, const Image& above);

/// Mean CIEDE2000 over the marked pixels, and the value that 95 % of them don't exceed.
struct ColorDifference {
  double mean = 0, p95 = 0;
};
ColorDifference color_difference(const Image& a, const Image& b, const Marks& where);

/// The share of covered pixels with a colour as computed below 0 or above 1, by more than 1e-6.
double share_out_of_gamut(const Image& image);

/// Whether every channel of every pixel is a number.
bool is_finite(const Image& image);

/// All covered pixels.
Marks covered(const Image& image);

}  // namespace lumaknot::paper
