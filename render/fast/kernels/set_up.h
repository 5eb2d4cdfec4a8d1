/// Triangle setup for a packet: ordered corners, edges and depths.
#pragma once

#include <algorithm>

#include "render/fast/kernels/packet.h"

namespace lumaknot::fast {

/// Triangles of at most this many pixels per side have edge functions of 32 bits.
constexpr int kSmall = 28;

/// The triangles of a packet, their corners in the order in which the area is positive.
template <class A>
struct Oriented {
  std::array<std::array<Ints<A>, 2>, 3> at;  ///< snapped
  std::array<Floats<A>, 3> depth;            ///< inverse
  Floats<A> slope_x, slope_y;                ///< of the inverse depth, per pixel
  std::array<Ints<A>, 2> min, max;           ///< of the corners
  Ints<A> area;  ///< before the exchange; twice the area for small triangles, undefined for others
  Ints<A> swapped;  ///< 1: the last two corners were exchanged
};

/// Several triangles set up for the samples of a tile. An edge function is
///   e(x, y) = (b.x - a.x) (y - a.y) - (b.y - a.y) (x - a.x) >= 0
/// inside, for each edge from a to b in the order in which the area is positive; samples on an edge
/// belong to the triangle whose left or top edge it is (Direct3D 11's rule), so the function is one
/// less on the other edges. All are integers: what two triangles share is drawn once.
template <class A>
struct SetUp {
  static constexpr std::size_t kWidth = Ints<A>::size;
  std::int32_t ax[3][kWidth], ay[3][kWidth];  ///< corners, oriented; an edge begins at each
  std::int32_t dx[3][kWidth], dy[3][kWidth];  ///< to the next corner
  float depth[3][kWidth];                     ///< inverse, of these corners
  float slope_x[kWidth], slope_y[kWidth];     ///< of the inverse depth, per pixel
  std::int32_t min[2][kWidth], max[2][kWidth];
  std::int32_t area[kWidth];     ///< before the exchange; twice the area for small triangles,
                                 ///< undefined for others
  std::int32_t swapped[kWidth];  ///< the last two corners were exchanged
};

template <class A>
Oriented<A> oriented(const FrameData& data, const Ints<A>& triangles) {
  Oriented<A> o;
  const std::array<Ints<A>, 3> corners = load_corners<A>(data, triangles);
  auto& p = o.at;
  auto& depth = o.depth;
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedPoints<A> point = load_points<A>(data, corners[i]);
    p[i] = point.at;
    depth[i] = point.inverse_depth;
  }
  for (std::size_t c = 0; c < 2; ++c) {
    o.min[c] = xsimd::min(xsimd::min(p[0][c], p[1][c]), p[2][c]);
    o.max[c] = xsimd::max(xsimd::max(p[0][c], p[1][c]), p[2][c]);
  }
  // Twice the area, positive where the corners run clockwise on the screen (y downwards).
  const Ints<A> x1 = p[1][0] - p[0][0], y1 = p[1][1] - p[0][1];
  const Ints<A> x2 = p[2][0] - p[0][0], y2 = p[2][1] - p[0][1];
  const Ints<A> area = wrapped_product<A>(x1, y2) - wrapped_product<A>(x2, y1);
  const auto swapped = area < Ints<A>(0);
  o.area = area;
  o.swapped = xsimd::select(swapped, Ints<A>(1), Ints<A>(0));
  const Floats<A> scale = Floats<A>(kSubpixels) / to_floats<A>(area);
  const Floats<A> d1 = depth[1] - depth[0], d2 = depth[2] - depth[0];
  o.slope_x = (d1 * to_floats<A>(y2) - d2 * to_floats<A>(y1)) * scale;
  o.slope_y = (d2 * to_floats<A>(x1) - d1 * to_floats<A>(x2)) * scale;
  // Exchange the last two corners of those that run the other way.
  for (std::size_t c = 0; c < 2; ++c) {
    const Ints<A> second = xsimd::select(swapped, p[2][c], p[1][c]);
    p[2][c] = xsimd::select(swapped, p[1][c], p[2][c]);
    p[1][c] = second;
  }
  const Floats<A> second =
      as_floats<A>(xsimd::select(swapped, as_ints<A>(depth[2]), as_ints<A>(depth[1])));
  depth[2] = as_floats<A>(xsimd::select(swapped, as_ints<A>(depth[1]), as_ints<A>(depth[2])));
  depth[1] = second;
  return o;
}

template <class A>
SetUp<A> set_up(const Oriented<A>& o) {
  SetUp<A> s;
  for (std::size_t c = 0; c < 2; ++c) {
    o.min[c].store_unaligned(s.min[c]);
    o.max[c].store_unaligned(s.max[c]);
  }
  o.area.store_unaligned(s.area);
  o.swapped.store_unaligned(s.swapped);
  o.slope_x.store(s.slope_x);
  o.slope_y.store(s.slope_y);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    o.at[i][0].store_unaligned(s.ax[i]);
    o.at[i][1].store_unaligned(s.ay[i]);
    (o.at[next][0] - o.at[i][0]).store_unaligned(s.dx[i]);
    (o.at[next][1] - o.at[i][1]).store_unaligned(s.dy[i]);
    o.depth[i].store(s.depth[i]);
  }
  return s;
}

/// What set_up() computes in 32 bits, repeated for a large triangle. Twice its area before the
/// exchange.
template <class A>
std::int64_t set_up_large(SetUp<A>& s, std::size_t k) {
  const std::int64_t x1 = s.ax[1][k] - std::int64_t(s.ax[0][k]),
                     y1 = s.ay[1][k] - std::int64_t(s.ay[0][k]);
  const std::int64_t x2 = s.ax[2][k] - std::int64_t(s.ax[0][k]),
                     y2 = s.ay[2][k] - std::int64_t(s.ay[0][k]);
  const std::int64_t area = x1 * y2 - x2 * y1;  // of the corners as they are now
  const double scale = double(kSubpixels) / double(area);
  const double d1 = double(s.depth[1][k]) - s.depth[0][k],
               d2 = double(s.depth[2][k]) - s.depth[0][k];
  s.slope_x[k] = float((d1 * double(y2) - d2 * double(y1)) * scale);
  s.slope_y[k] = float((d2 * double(x1) - d1 * double(x2)) * scale);
  const std::int64_t before = s.swapped[k] ? -area : area;
  if (area >= 0) return before;
  std::swap(s.ax[1][k], s.ax[2][k]);
  std::swap(s.ay[1][k], s.ay[2][k]);
  std::swap(s.depth[1][k], s.depth[2][k]);
  for (std::size_t i = 0; i < 3; ++i) {
    s.dx[i][k] = s.ax[(i + 1) % 3][k] - s.ax[i][k];
    s.dy[i][k] = s.ay[(i + 1) % 3][k] - s.ay[i][k];
  }
  return before;
}

}  // namespace lumaknot::fast
