/// The YIQ space of the paper's eq. 4 and 5: luma, and two chroma axes that carry the hue.
#pragma once

#include "math/number.h"

namespace lumaknot {

/// M of eq. 4: its rows give Y, I, Q from the encoded r'g'b'.
inline constexpr Vec3d kYiqFromRgb[3] = {{0.29889531, 0.58662247, 0.11448223},
                                         {0.59597799, -0.27417610, -0.32180189},
                                         {0.21147017, -0.52261711, 0.31114694}};

/// The last two columns of W of eq. 5; its first is all ones.
inline constexpr Vec3d kRgbFromI{0.95608445, -0.27137664, -1.10561724};
inline constexpr Vec3d kRgbFromQ{0.62088850, -0.64860590, 1.70250126};

/// Y in [0, 1], I in [-0.5957, 0.5957], Q in [-0.5226, 0.5226] for colours of the RGB cube.
template <class S>
struct Yiq {
  S y, i, q;
};

/// Eq. 4.
template <class S>
Yiq<S> yiq_from_rgb(const Vec<S>& rgb) {
  return {named("y", dot(constant_vec<S>(kYiqFromRgb[0]), rgb)),
          named("i", dot(constant_vec<S>(kYiqFromRgb[1]), rgb)),
          named("q", dot(constant_vec<S>(kYiqFromRgb[2]), rgb))};
}

/// Eq. 5. M and W are inverse to each other up to 1e-7 (their printed digits).
template <class S>
Vec<S> rgb_from_yiq(const Yiq<S>& yiq) {
  return make_vec(yiq.y, yiq.y, yiq.y) + constant_vec<S>(kRgbFromI) * yiq.i +
         constant_vec<S>(kRgbFromQ) * yiq.q;
}

}  // namespace lumaknot
