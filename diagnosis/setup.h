/// What a picture is drawn with: the scene as given, and everything in which a renderer may have
/// departed from it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "diagnosis/rows.h"
#include "diagnosis/tone.h"
#include "render/filter.h"
#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::diagnosis {

/// How texels become the surface's colour.
enum class Sampling { kBilinear, kNearest, kMipmapped };

/// A curve that each channel of a colour is sent through.
enum class Curve { kNone, kEncodeSrgb, kDecodeSrgb };

/// What a curve makes of negative values, for which none is defined.
enum class Below { kOdd, kZero, kStraight };  ///< mirrored, cut off, or the first slope continued

/// How the texture is read.
struct TextureUse {
  double u_scale = 1, v_scale = 1;    ///< of the mesh's texture coordinates
  double u_offset = 0, v_offset = 0;  ///< added to them then
  bool swapped = false;               ///< u and v exchanged, before both
  Sampling sampling = Sampling::kBilinear;
  Wrapping wrapping = Wrapping::kRepeat;
  double texel_shift = 0;  ///< texels by which both coordinates are off
  // What is done to each colour, in this order.
  std::array<std::size_t, 3> channels{0, 1, 2};
  double gamma = 1;  ///< the exponent of each channel
  Curve curve = Curve::kNone;
  double saturation = 1;         ///< 0: the grey of its luma
  bool after_filtering = false;  ///< all of that to the filtered colour instead of the texels
};

/// How the surface's normals come about.
struct NormalUse {
  bool flat = false;      ///< the triangle's
  bool inverted = false;  ///< pointing inwards
  bool turned = false;    ///< to the viewer
};

/// Where the picture lies on the image plane: its centre is moved, its sides are scaled, negative
/// ones mirrored. Pixels.
struct Placement {
  double scale_x = 1, scale_y = 1, shift_x = 0, shift_y = 0;
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// What happens between the surface's colours and the pixels.
struct PictureUse {
  Placement placement;
  bool resampled = false;  ///< the placement moves a finished picture, bilinearly
  int samples = 1;         ///< samples x samples per pixel
  double filter = 1;       ///< the width that they are spread over, pixels
  double blur = 0;         ///< standard deviation of a Gaussian, pixels
  int median = 0;          ///< radius of a median filter, pixels
};

/// What is done to each colour, in this order.
struct ColorUse {
  Vec3d gain{1, 1, 1};
  double offset = 0;
  double contrast = 1;    ///< about 0.5
  double saturation = 1;  ///< 0: the grey of its luma
  double hue = 0;         ///< radians, about the grey axis of YIQ
  Rows primaries{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Tone tone = Tone::kNone;
  ToneSpline spline;
  std::vector<double> spline_values;  ///< of each channel; empty: none
  double gamma = 1;                   ///< the exponent of each channel is 1 / gamma
  Curve curve = Curve::kNone;
  Below below = Below::kOdd;  ///< of gamma and curve
  std::array<std::size_t, 3> channels{0, 1, 2};
  bool inverted = false;  ///< the negative
  bool limited = false;   ///< to [0, 1]
  int levels = 0;         ///< each channel is rounded to levels - 1 steps; 0: not at all
  double by_alpha = 0;    ///< divided (-1) or multiplied (1) by the coverage once more
};

/// All of it. Copies share the mesh and the texture.
struct Setup {
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const Texture> texture;
  View view;  ///< its image has the size of the picture
  Stage stage = Stage::kFinal;
  NormalUse normals;
  TextureUse texturing;
  bool shadows = false;
  PictureUse picture;
  ColorUse color;
};

}  // namespace lumaknot::diagnosis
