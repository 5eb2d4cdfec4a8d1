/// The parts of a lighting model: a diffuse term and a highlight, each a type whose static
/// members are all that is particular to it. Symbols: Kotsarenko and Ramos, "Alternative Diffuse
/// Lighting and Specular Reflection Approach Using YIQ Color Space"; n, l, v, h: unit normal, to
/// the light, to the eye, half way between.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "math/interval.h"
#include "math/number.h"

namespace lumaknot {

/// The directions at a point that a term asks for.
template <class S>
struct Directions {
  Vec<S> n, l, v;
  S n_dot_l;
};

/// A number that a term reads, as users see it. Terms may share a name: they then read the same
/// number and agree on all but its range and meaning.
struct Parameter {
  std::string_view name;    ///< its JSON key and its name in shaders
  double value;             ///< the default
  Interval<double> range;   ///< in scenes
  Interval<double> slider;  ///< in tools
  double step;              ///< of the slider
  std::string_view unit;
  std::string_view meaning;
  std::string_view semantic = {};  ///< in the Standard Annotations and Semantics, if it has one
};

/// Numbers, one for each of a term's parameters, for which the table of energy lists it.
template <std::size_t n>
struct EnergySample {
  std::string_view name;
  std::array<double, n> numbers;
};

/// How POV-Ray 3.7 draws a term.
struct PovTerm {
  std::string_view lack = {};     ///< after "POV-Ray can't"; empty: it draws the term
  std::string_view nearest = {};  ///< the setting that it does draw
  // Of a highlight that it draws, in `finish`:
  std::string_view weight = {};  ///< the keyword of the weight
  std::string_view width = {};   ///< the keyword of the width
  double width_value = 0;
};

// A term has these static members; `...` is a number for each of its parameters.
//
//   kParameters                     array of Parameter
//   value(directions, ...)          the formula, over any number type
//   largest(...)                    its largest value, infinite if there is none
//   slope(...)                      its largest change per radian that the normal turns, if known
//   interpolation_error(turn, ...)  the largest error, if known, where it is interpolated between
//                                   vertices whose normals and directions differ by `turn` radians
//   pov(...)                        PovTerm
//   kEnergySamples                  array of EnergySample
//
// A highlight has two more:
//
//   ggx_roughness(...)    the square root of GGX's alpha whose lobe is as wide
//   rounding_growth(...)  the factor by which it multiplies the relative error of a cosine
//
// A model is a type with its name, kName, and its terms, Diffuse and Highlight.

}  // namespace lumaknot
