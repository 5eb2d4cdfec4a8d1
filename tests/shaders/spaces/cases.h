/// Shared by the tests of the colour spaces.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "shaders/spaces/conversions.h"

namespace lumaknot {

inline constexpr std::array<Space, 7> kLumaSpaces{Space::kYiq,    Space::kYuv601, Space::kYuv709,
                                                  Space::kCielab, Space::kCieluv, Space::kDin99,
                                                  Space::kAtd95};
inline constexpr std::array<Space, 4> kCurvedSpaces{Space::kCielab, Space::kCieluv, Space::kDin99,
                                                    Space::kAtd95};

inline std::string name_of(Space space) { return std::string(kSpaceNames[std::size_t(space)]); }

/// steps^3 colours, evenly spaced over the RGB cube, its corners among them.
inline std::vector<Vec3d> color_cube(int steps) {
  std::vector<Vec3d> colors;
  const double last = steps - 1;
  for (int r = 0; r < steps; ++r)
    for (int g = 0; g < steps; ++g)
      for (int b = 0; b < steps; ++b) colors.push_back({r / last, g / last, b / last});
  return colors;
}

template <class S>
Vec3<S> narrowed(const Vec3d& v) {
  return {S(v.x), S(v.y), S(v.z)};
}

inline Vec3d widened(const Vec3<float>& v) { return {v.x, v.y, v.z}; }
inline Vec3d widened(const Vec3d& v) { return v; }

/// `rgb` after light that multiplies its brightness and adds a highlight.
template <class S>
Vec3<S> with_light(const Vec3<S>& rgb, S light, S highlight, Space space) {
  Axes<S> axes = axes_from_rgb<S>(rgb, space);
  axes.brightness = axes.brightness * light + highlight;
  return rgb_from_axes(axes, space);
}

}  // namespace lumaknot
