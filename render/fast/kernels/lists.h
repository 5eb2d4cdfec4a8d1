/// The second step of a frame: which tiles each triangle may touch.
#pragma once

#include "render/fast/kernels/packet.h"

namespace lumaknot::fast {

inline constexpr int kTileBits = 6;
static_assert(kTile == 1 << kTileBits);

/// Where each lane's triangle is on the image.
template <class A>
struct Placed {
  xsimd::batch_bool<std::int32_t, A> outside;  ///< whether a corner is
  xsimd::batch_bool<std::int32_t, A> seen;     ///< its samples may lie in pixels of the image
  Ints<A> tiles;                               ///< that it touches: TileSpan
};

template <class A>
Placed<A> placed(const FrameData& data, const Ints<A>& triangles) {
  using I = Ints<A>;
  const std::array<I, 3> corners = load_corners<A>(data, triangles);
  std::array<std::array<I, 2>, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = load_points<A>(data, corners[i]).at;
  const std::array<int, 2> size{data.width, data.height};
  const bool centres = data.options.samples == 1;
  std::array<I, 2> min, first, last;
  for (std::size_t c = 0; c < 2; ++c) {
    min[c] = xsimd::min(xsimd::min(points[0][c], points[1][c]), points[2][c]);
    const I max = xsimd::max(xsimd::max(points[0][c], points[1][c]), points[2][c]);
    first[c] = xsimd::max(first_pixel<A>(min[c], centres), I(0));
    last[c] = xsimd::min(last_pixel<A>(max, centres), I(size[c] - 1));
  }
  const auto seen = first[0] <= last[0] && first[1] <= last[1];
  const I x = first[0] >> kTileBits, y = first[1] >> kTileBits;
  const I right = (last[0] >> kTileBits) - x, down = (last[1] >> kTileBits) - y;
  return {min[0] == I(kOutside), seen,
          (x + y * I(data.columns)) | right << TileSpan::kRight | down << TileSpan::kDown};
}

/// Stores the lanes where `mask` is set, one after the other; the rest of the packet behind them is
/// overwritten. Returns their number.
template <class A>
std::size_t store_where(const xsimd::batch_bool<std::int32_t, A>& mask, const Ints<A>& values,
                        std::uint32_t* to) {
  std::int32_t lanes[Ints<A>::size];
  bool kept[Ints<A>::size];
  values.store_unaligned(lanes);
  mask.store_unaligned(kept);
  std::size_t count = 0;
  for (std::size_t k = 0; k < Ints<A>::size; ++k) {
    to[count] = std::uint32_t(lanes[k]);
    count += kept[k];
  }
  return count;
}
#ifdef __AVX512F__
template <>
inline std::size_t store_where<xsimd::avx512bw>(
    const xsimd::batch_bool<std::int32_t, xsimd::avx512bw>& mask,
    const Ints<xsimd::avx512bw>& values, std::uint32_t* to) {
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, values));
  return std::size_t(__builtin_popcount(__mmask16(mask)));
}
#endif

template <class A>
void find_candidates(const FrameData& data, Run& run, std::uint32_t first, std::uint32_t last);

/// As find_candidates(), when clipping cut some of the triangles.
template <class A>
void find_one_by_one(const FrameData& data, Run& run, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t t = first; t < last; ++t) {
    const Placed<A> p = placed<A>(data, Ints<A>(std::int32_t(t)));
    if (!xsimd::any(p.outside)) {
      run.candidates[run.found] = t;
      run.tiles[run.found] = std::uint32_t(p.tiles.get(0));
      run.found += xsimd::any(p.seen);
    } else if (const Clipped* pieces = find_clipped(data, t, t + 1)) {
      find_candidates<A>(data, run, pieces->first, pieces->first + pieces->count);
    }
  }
}

/// Adds triangles [first, last) to the run's candidates, with the pieces in place of those that
/// clipping cut.
template <class A>
void find_candidates(const FrameData& data, Run& run, std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kWidth = std::uint32_t(Ints<A>::size);
  for (std::uint32_t t = first; t < last; t += kWidth) {
    // Lanes past the last triangle repeat it.
    const Ints<A> numbers = lane_numbers<A>() + Ints<A>(std::int32_t(t));
    const Ints<A> triangles = xsimd::min(numbers, Ints<A>(std::int32_t(last - 1)));
    const Placed<A> p = placed<A>(data, triangles);
    const std::uint32_t end = std::min(t + kWidth, last);
    if (xsimd::any(p.outside) && find_clipped(data, t, end)) {
      find_one_by_one<A>(data, run, t, end);
      continue;
    }
    const auto kept = p.seen && !p.outside && numbers == triangles;
    store_where<A>(kept, triangles, &run.candidates[run.found]);
    run.found += store_where<A>(kept, p.tiles, &run.tiles[run.found]);
  }
}

}  // namespace lumaknot::fast
