/// What a renderer promises: how exactly it computes. The limit of each pixel follows from it.
#pragma once

#include <string_view>

namespace lumaknot::validate {

/// The precision of each step of a picture. Roundings are counted in half units in the last place
/// of float32: 2^-24 of a value.
struct Promise {
  int grid_bits = 0;            ///< vertices are snapped to 2^-bits pixel; 0: they are not
  bool snaps_shade = false;     ///< what is interpolated between them moves along
  double sample_roundings = 2;  ///< of a sample's place in the image, through all transforms
  double position_roundings = 4, normal_roundings = 4, uv_roundings = 4;  ///< as interpolated
  double formula_roundings = 4;  ///< times those of the formula's steps
  double power_error = 0;        ///< of pow(), relative, for an exponent of 0 and per unit of it
  double texture_step = 0;       ///< of a texture file, for a texture that has finer ones
  double texel_weight = 0;       ///< error of the texture filter's weights
  double output_step = 0;        ///< of the image's values, absolute
  double output_relative = 0;    ///< the same, relative to the value
  double unexplained = 0;        ///< outliers without a class, as a share of the silhouette
  std::string_view reason = {};
};

inline constexpr double kStep16 = 1.0 / 65535;  ///< of integers of 16 bits
inline constexpr double kStepHalf = 0x1p-10;    ///< of half floats, relative

}  // namespace lumaknot::validate
