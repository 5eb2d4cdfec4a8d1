/// The second step of a frame: which tiles each triangle may touch.
#pragma once

#include "render/kernels/packet.h"

namespace lumaknot {

inline constexpr int kTileBits = 6;
static_assert(kTile == 1 << kTileBits);

/// The pixels [x0, x1] x [y0, y1] of each lane's triangle in which its samples may lie; `outside`
/// is kOutside where a corner is.
template <class A>
struct Boxes {
  std::int32_t x0[Ints<A>::size], y0[Ints<A>::size], x1[Ints<A>::size], y1[Ints<A>::size];
  std::int32_t outside[Ints<A>::size];
};

template <class A>
Boxes<A> pixel_boxes(const FrameData& data, const Ints<A>& triangle) {
  const std::array<Ints<A>, 3> corners = load_corners<A>(data, triangle);
  std::array<std::array<Ints<A>, 2>, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = load_points<A>(data, corners[i]).at;
  const auto least = [&](std::size_t c) {
    return xsimd::min(xsimd::min(points[0][c], points[1][c]), points[2][c]);
  };
  const auto most = [&](std::size_t c) {
    return xsimd::max(xsimd::max(points[0][c], points[1][c]), points[2][c]);
  };
  Boxes<A> boxes;
  const bool centres = data.options.samples == 1;
  const auto put_first = [&](std::size_t c, std::int32_t* to) {
    xsimd::max(first_pixel<A>(least(c), centres), Ints<A>(0)).store_unaligned(to);
  };
  const auto put_last = [&](std::size_t c, int size, std::int32_t* to) {
    xsimd::min(last_pixel<A>(most(c), centres), Ints<A>(size - 1)).store_unaligned(to);
  };
  put_first(0, boxes.x0);
  put_first(1, boxes.y0);
  put_last(0, data.width, boxes.x1);
  put_last(1, data.height, boxes.y1);
  least(0).store_unaligned(boxes.outside);
  return boxes;
}

/// Keeps a triangle whose samples' box is (x0, y0) ... (x1, y1), in pixels.
template <class A>
void keep_candidate(Run& run, std::uint32_t triangle, int x0, int y0, int x1, int y1) {
  run.boxes[run.found] = {std::uint8_t(x0 >> kTileBits), std::uint8_t(y0 >> kTileBits),
                          std::uint8_t(x1 >> kTileBits), std::uint8_t(y1 >> kTileBits)};
  run.candidates[run.found] = triangle;
  run.found += x0 <= x1 && y0 <= y1;
}

/// Adds triangles [first, last) to the run's candidates, in place of those that clipping cut what
/// it made of them.
template <class A>
void find_candidates(const FrameData& data, Run& run, std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kWidth = std::uint32_t(Ints<A>::size);
  for (std::uint32_t t = first; t < last; t += kWidth) {
    // Lanes behind the last triangle repeat it.
    const Ints<A> triangles =
        xsimd::min(lane_numbers<A>() + Ints<A>(std::int32_t(t)), Ints<A>(std::int32_t(last - 1)));
    const Boxes<A> b = pixel_boxes<A>(data, triangles);
    for (std::uint32_t k = 0; k < kWidth && t + k < last; ++k) {
      if (b.outside[k] != kOutside) {
        keep_candidate<A>(run, t + k, b.x0[k], b.y0[k], b.x1[k], b.y1[k]);
      } else if (const Clipped* pieces = find_clipped(data, t + k)) {
        find_candidates<A>(data, run, pieces->first, pieces->first + pieces->count);
      }
    }
  }
}

}  // namespace lumaknot
