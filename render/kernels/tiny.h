/// Triangles of a few pixels, a packet of them at once: a lane each, position by position of their
/// boxes; what is inside is then tested for depth.
#pragma once

#include "render/kernels/coverage.h"

namespace lumaknot {

/// At most this many pixels a side.
inline constexpr int kTiny = 8;

template <class A>
bool are_tiny(const Oriented<A>&) {
  return false;
}
template <class A>
void draw_tiny(const Oriented<A>&, const Ints<A>&, bool, const TileTarget&) {}

#ifdef __AVX512F__
using Lanes = xsimd::avx512bw;

inline bool are_tiny(const Oriented<Lanes>& o) {
  const Ints<Lanes> wide = xsimd::max(o.most[0] - o.least[0], o.most[1] - o.least[1]);
  return xsimd::all(wide <= Ints<Lanes>(kTiny * kSubpixels));
}

/// Edge functions' complements, which are negative inside; at a first pixel's centre, and a pixel.
struct TinyEdges {
  std::array<Ints<Lanes>, 3> first, right, down;
};

inline TinyEdges tiny_edges(const Oriented<Lanes>& o, const Ints<Lanes>& x, const Ints<Lanes>& y,
                            __mmask16 drawn) {
  using I = Ints<Lanes>;
  TinyEdges e;
  const I px = (x << kSubpixelBits) + I(kSubpixels / 2), py = (y << kSubpixelBits) + I(kSubpixels / 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = o.at[i], &b = o.at[(i + 1) % 3];
    const I dx = b[0] - a[0], dy = b[1] - a[1];
    const auto owns = dy < I(0) || (dy == I(0) && dx > I(0));
    const I value = wrapped_product<Lanes>(dy, px - a[0]) - wrapped_product<Lanes>(dx, py - a[1]);
    e.first[i] = _mm512_maskz_sub_epi32(drawn, value, xsimd::select(owns, I(1), I(0)));
    e.right[i] = _mm512_maskz_slli_epi32(drawn, dy, kSubpixelBits);
    e.down[i] = _mm512_maskz_slli_epi32(drawn, I(0) - dx, kSubpixelBits);
  }
  return e;
}

/// hits: lane + 16 column + 256 row of what is inside. Their count.
inline std::size_t find_hits(const TinyEdges& e, int columns, int rows, std::int32_t* hits) {
  std::size_t count = 0;
  std::array<__m512i, 3> row{e.first[0], e.first[1], e.first[2]};
  __m512i row_word = lane_numbers<Lanes>();
  for (int y = 0; y < rows; ++y) {
    std::array<__m512i, 3> f = row;
    __m512i word = row_word;
    for (int x = 0; x < columns; ++x) {
      const __m512i inside = _mm512_ternarylogic_epi32(f[0], f[1], f[2], 0x80);
      const __mmask16 mask = _mm512_movepi32_mask(inside);
      _mm512_storeu_si512(hits + count, _mm512_maskz_compress_epi32(mask, word));
      count += std::size_t(__builtin_popcount(mask));
      for (std::size_t i = 0; i < 3; ++i) f[i] = _mm512_add_epi32(f[i], e.right[i]);
      word = _mm512_add_epi32(word, _mm512_set1_epi32(16));
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] = _mm512_add_epi32(row[i], e.down[i]);
    row_word = _mm512_add_epi32(row_word, _mm512_set1_epi32(256));
  }
  return count;
}

[[gnu::noinline]] inline void keep_hits(const std::int32_t* ats, const std::int32_t* new_depths, const std::int32_t* triangles, std::size_t count, std::int32_t* __restrict depths, std::int32_t* __restrict seen) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t a = std::size_t(ats[i]);
      const std::uint64_t old = std::uint64_t(std::uint32_t(depths[a])) << 32 | std::uint32_t(seen[a]);
      const std::uint64_t key = std::uint64_t(std::uint32_t(new_depths[i])) << 32 | std::uint32_t(triangles[i]);
      std::uint64_t best = key > old ? key : old;
      asm("" : "+r"(best));
      depths[a] = std::int32_t(best >> 32);
      seen[a] = std::int32_t(best);
    }
}

inline void draw_tiny(const Oriented<Lanes>& o, const Ints<Lanes>& numbers, bool cull,
                      const TileTarget& tile) {
  using I = Ints<Lanes>;
  using S = Floats<Lanes>;
  const I x0 = xsimd::max(first_pixel<Lanes>(o.least[0], true), I(tile.x0));
  const I y0 = xsimd::max(first_pixel<Lanes>(o.least[1], true), I(tile.y0));
  const I x1 = xsimd::min(last_pixel<Lanes>(o.most[0], true), I(tile.x1 - 1));
  const I y1 = xsimd::min(last_pixel<Lanes>(o.most[1], true), I(tile.y1 - 1));
  auto drawn = x0 <= x1 && y0 <= y1 && o.area != I(0);
  if (cull) drawn = drawn && o.area < I(0);
  const __mmask16 mask = __mmask16(drawn);
  const int columns = _mm512_mask_reduce_max_epi32(mask, x1 - x0) + 1;
  const int rows = _mm512_mask_reduce_max_epi32(mask, y1 - y0) + 1;
  alignas(64) std::int32_t hits[(kTiny + 1) * (kTiny + 1) * 16 + 16];
  const TinyEdges edges = tiny_edges(o, x0, y0, mask);
  const std::size_t count = find_hits(edges, columns, rows, hits);
  const S scale(1.0 / kSubpixels);
  const S at_x = to_floats<Lanes>((x0 << kSubpixelBits) + I(kSubpixels / 2) - o.at[0][0]) * scale;
  const S at_y = to_floats<Lanes>((y0 << kSubpixelBits) + I(kSubpixels / 2) - o.at[0][1]) * scale;
  const S first = o.depth[0] + o.slope_x * at_x + o.slope_y * at_y;
  const S least = min(min(o.depth[0], o.depth[1]), o.depth[2]);
  const S most = max(max(o.depth[0], o.depth[1]), o.depth[2]);
  const I corner = (y0 - I(tile.y0)) << 8 | (x0 - I(tile.x0));
  // Columns beyond the tile's go to where nothing is read.
  for (std::size_t begin = 0; begin < count; begin += 16) {
    const I hit(_mm512_load_si512(hits + begin));
    const I lane = hit & I(15);
    const auto of_lane = [&](const S& v) { return S(S::Batch(_mm512_permutexvar_ps(lane, v.v))); };
    const auto int_of_lane = [&](const I& v) { return I(_mm512_permutexvar_epi32(lane, v)); };
    const I dx = (hit >> 4) & I(15), dy = hit >> 8;
    const S z = min(max(of_lane(first) + of_lane(o.slope_x) * to_floats<Lanes>(dx) +
                            of_lane(o.slope_y) * to_floats<Lanes>(dy),
                        of_lane(least)),
                    of_lane(most));
    const I place = int_of_lane(corner), x = (place & I(255)) + dx, y = (place >> 8) + dy;
    const I at = (x & I(3)) + ((x >> 2) << 4) + ((y & I(3)) << 2) + ((y >> 2) << 8);
    const auto in = x <= I(tile.x1 - 1 - tile.x0) && y <= I(tile.y1 - 1 - tile.y0);
    const I safe = xsimd::select(in, at, I(kTile * kTile));
    alignas(64) std::int32_t ats[16], depths[16], triangles[16];
    safe.store_aligned(ats);
    as_ints<Lanes>(z).store_aligned(depths);
    int_of_lane(numbers).store_aligned(triangles);
    keep_hits(ats, depths, triangles, std::min<std::size_t>(16, count - begin), tile.depths, tile.seen);
  }
}
#endif

}  // namespace lumaknot
