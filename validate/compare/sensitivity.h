/// How much a pixel's colour changes with all that a renderer may compute inexactly.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "validate/compare/explain.h"
#include "validate/renderers/promise.h"

namespace lumaknot::validate {

/// The parts of a limit, in the order of LimitParts::of.
enum class LimitPart {
  kSnapped,
  kSample,
  kPosition,
  kNormal,
  kTexture,
  kTexel,
  kFilter,
  kFormula,
  kOutput
};
inline constexpr std::array<std::string_view, 9> kLimitPartNames{
    "vertices on a grid", "sample's place", "position", "normal", "texture coordinates",
    "texture file",       "texture filter", "formula",  "output"};

/// A limit of an error, as the sum of its parts. Those that are random are four standard
/// deviations, and add up as such.
struct LimitParts {
  std::array<double, kLimitPartNames.size()> of{};
  double sum() const;
};

/// Of one pixel; each is the largest of the three channels.
struct Sensitivity {
  float step = 0;                ///< per pixel that the sample moves in x, and in y
  float formula = 0, power = 0;  ///< standard deviations, of one rounding each
  float position = 0, normal = 0, texture = 0;
  float texel = 0;         ///< for a texture file of 16 bits
  float filter = 0;        ///< per unit of a texel's weight
  float size = 0;          ///< of the colour
  float sample_scale = 0;  ///< how large the numbers are that a sample's place is computed from
  float slope_x = 0, slope_y = 0;  ///< per pixel, signed, of `channel`
  std::uint8_t channel = 0;        ///< which changes most
};

/// Of all pixels of a shot. On all cores.
Grid<Sensitivity> sensitivities(const Reference& reference, const Shot& shot);

/// Of a pixel that shows `fragment`.
Sensitivity sensitivity_of(const Reference& reference, const Shot& shot, const Fragment& fragment,
                           PixelPlace place);

/// The limit of a pixel's error for a renderer that keeps `promise`, whose image adds up
/// `output_steps` steps.
LimitParts limit_of(const Sensitivity& pixel, const Promise& promise, double output_steps = 1);

/// By how many pixels a renderer's samples may lie off the pixel's centre without its grid.
double sample_error(const Sensitivity& pixel, const Promise& promise);

/// By how many pixels an edge of the surface may pass by a sample and still change what it sees.
double edge_distance(const Sensitivity& pixel, const Promise& promise);

}  // namespace lumaknot::validate
