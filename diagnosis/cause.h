/// What the causes share.
#pragma once

#include "diagnosis/hypothesis.h"

namespace lumaknot::diagnosis {

/// An order of the channels other than rgb.
struct Permutation {
  std::string_view name;
  std::array<std::size_t, 3> order;
};
inline constexpr std::array<Permutation, 5> kPermutations{{{"bgr", {2, 1, 0}},
                                                           {"grb", {1, 0, 2}},
                                                           {"rbg", {0, 2, 1}},
                                                           {"gbr", {1, 2, 0}},
                                                           {"brg", {2, 0, 1}}}};

/// A number as sentences show it: five digits.
std::string number(double value);

/// "(x, y, z)"
std::string point(const Vec3d& p);

/// Whether the surface has a texture of more than one colour.
bool has_image(const Situation& situation);

/// The position or the falloff of a light; null if its kind has none.
Vec3d* position_of(Light& light);
Falloff* falloff_of(Light& light);

}  // namespace lumaknot::diagnosis
