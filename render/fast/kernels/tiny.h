/// Triangles of a few pixels, a packet of them at once, one per lane: they step through their boxes
/// together, and the samples inside are packed and then depth-tested, sample by sample.
#pragma once

#include "render/fast/kernels/coverage.h"

namespace lumaknot::fast {

/// At most this many pixels per side.
inline constexpr int kTiny = 12;

/// Whether draw_tiny() can draw the packet; never without instructions that pack lanes.
template <class A>
bool are_tiny(const Oriented<A>&) {
  return false;
}
template <class A>
void draw_tiny(const Oriented<A>&, const Ints<A>&, bool, const TileTarget&) {}

#ifdef __AVX512F__
// Static, since the linker may keep an inline function from any one file.
using Lanes = xsimd::avx512bw;

static bool are_tiny(const Oriented<Lanes>& o) {
  const Ints<Lanes> side = xsimd::max(o.max[0] - o.min[0], o.max[1] - o.min[1]);
  return xsimd::all(side <= Ints<Lanes>(kTiny * kSubpixels));
}

/// The boxes of pixels that may hold the triangles' samples.
struct TinyBoxes {
  Ints<Lanes> x, y;   ///< the first pixel
  __mmask16 drawn;    ///< whether any pixel is
  int columns, rows;  ///< of the largest
};

static TinyBoxes tiny_boxes(const Oriented<Lanes>& o, bool cull, const TileTarget& tile) {
  using I = Ints<Lanes>;
  const bool centres = tile.pattern.size() == 1;
  TinyBoxes b;
  b.x = xsimd::max(first_pixel<Lanes>(o.min[0], centres), I(tile.x0));
  b.y = xsimd::max(first_pixel<Lanes>(o.min[1], centres), I(tile.y0));
  const I x1 = xsimd::min(last_pixel<Lanes>(o.max[0], centres), I(tile.x1 - 1));
  const I y1 = xsimd::min(last_pixel<Lanes>(o.max[1], centres), I(tile.y1 - 1));
  const auto faces = cull ? o.area < I(0) : o.area != I(0);
  b.drawn = __mmask16(faces && b.x <= x1 && b.y <= y1);
  b.columns = _mm512_mask_reduce_max_epi32(b.drawn, x1 - b.x) + 1;
  b.rows = _mm512_mask_reduce_max_epi32(b.drawn, y1 - b.y) + 1;
  return b;
}

/// The complements of edge functions, negative inside: at the centres of the boxes' first pixels,
/// and their change per pixel. Zero where nothing is drawn.
struct TinyEdges {
  __m512i first[3], right[3], down[3];

  /// Function number `i` at the first pixel's sample.
  __m512i at(std::size_t i, SamplePlace place) const {
    static_assert(kSubpixels % 16 == 0);  // exact
    const __m512i x =
        _mm512_mullo_epi32(_mm512_srai_epi32(right[i], 4), _mm512_set1_epi32(place.x));
    const __m512i y = _mm512_mullo_epi32(_mm512_srai_epi32(down[i], 4), _mm512_set1_epi32(place.y));
    return _mm512_add_epi32(first[i], _mm512_add_epi32(x, y));
  }
};

static TinyEdges tiny_edges(const Oriented<Lanes>& o, const TinyBoxes& b) {
  using I = Ints<Lanes>;
  TinyEdges e;
  const I x = (b.x << kSubpixelBits) + I(kSubpixels / 2);
  const I y = (b.y << kSubpixelBits) + I(kSubpixels / 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &from = o.at[i], &to = o.at[(i + 1) % 3];
    const I dx = to[0] - from[0], dy = to[1] - from[1];
    const auto owns = dy < I(0) || (dy == I(0) && dx > I(0));
    const I outside =
        wrapped_product<Lanes>(dy, x - from[0]) - wrapped_product<Lanes>(dx, y - from[1]);
    e.first[i] = _mm512_maskz_sub_epi32(b.drawn, outside, xsimd::select(owns, I(1), I(0)));
    e.right[i] = _mm512_maskz_slli_epi32(b.drawn, dy, kSubpixelBits);
    e.down[i] = _mm512_maskz_slli_epi32(b.drawn, I(0) - dx, kSubpixelBits);
  }
  return e;
}

/// Samples inside, in any order, each as lane + 16 column + 256 row of its triangle's box.
struct Hits {
  std::size_t count = 0;
  alignas(64) std::int32_t words[16 * (kTiny + 1) * (kTiny + 1) + 16];  // whole packets are stored
};

template <bool one>
static void find_hits(const TinyEdges& e, const TinyBoxes& b, SamplePlace place, Hits& hits) {
  hits.count = 0;
  __m512i row[3];
  for (std::size_t i = 0; i < 3; ++i) row[i] = one ? e.first[i] : e.at(i, place);
  for (int y = 0; y < b.rows; ++y) {
    __m512i at[3] = {row[0], row[1], row[2]};
    __m512i word = _mm512_add_epi32(lane_numbers<Lanes>(), _mm512_set1_epi32(256 * y));
    for (int x = 0; x < b.columns; ++x) {
      const __mmask16 inside =
          _mm512_movepi32_mask(_mm512_ternarylogic_epi32(at[0], at[1], at[2], 0x80));  // all three
      _mm512_storeu_si512(hits.words + hits.count, _mm512_maskz_compress_epi32(inside, word));
      hits.count += std::size_t(__builtin_popcount(inside));
      for (std::size_t i = 0; i < 3; ++i) at[i] = _mm512_add_epi32(at[i], e.right[i]);
      word = _mm512_add_epi32(word, _mm512_set1_epi32(16));
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] = _mm512_add_epi32(row[i], e.down[i]);
  }
}

/// Samples: their positions in the tile, and what they may see.
struct Found {
  alignas(64) std::int32_t at[16];
  alignas(64) std::uint64_t key[16];
};

/// As Nearest::keep(), sample by sample; at equal depths the later triangle wins, in whatever order
/// they come. A separate function for the sake of its registers.
[[gnu::noinline]] static void keep_found(const Found& found, std::size_t count,
                                         std::uint64_t* __restrict nearest) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = std::uint32_t(found.at[i]);
    std::uint64_t best = std::max(nearest[at], found.key[i]);
    asm("" : "+r"(best));  // no branch: it would be unpredictable
    nearest[at] = best;
  }
}

/// Inverse depths of a packet's triangles.
struct TinyDepths {
  Floats<Lanes> first;  ///< at the boxes' first pixels' centres
  Floats<Lanes> min, max;
};

static TinyDepths tiny_depths(const Oriented<Lanes>& o, const TinyBoxes& b) {
  using S = Floats<Lanes>;
  const auto from_corner = [&](const Ints<Lanes>& pixel, const Ints<Lanes>& corner) {
    const Ints<Lanes> centre = (pixel << kSubpixelBits) + Ints<Lanes>(kSubpixels / 2);
    return to_floats<Lanes>(centre - corner) * S(1.0 / kSubpixels);
  };
  return {o.depth[0] + o.slope_x * from_corner(b.x, o.at[0][0]) +
              o.slope_y * from_corner(b.y, o.at[0][1]),
          min(min(o.depth[0], o.depth[1]), o.depth[2]),
          max(max(o.depth[0], o.depth[1]), o.depth[2])};
}

/// Draws what was found of sample number `sample`. `one`: it is the only one, at the centre.
template <bool one>
static void draw_hits(const Hits& hits, std::size_t sample, const Oriented<Lanes>& o,
                      const Ints<Lanes>& numbers, const TinyBoxes& boxes, const TinyDepths& depths,
                      const TileTarget& tile) {
  using I = Ints<Lanes>;
  using S = Floats<Lanes>;
  const SamplePlace place = one ? SamplePlace{0, 0} : tile.pattern[sample];
  const std::int32_t samples = one ? 1 : std::int32_t(tile.pattern.size());
  const I left = boxes.x - I(tile.x0), top = boxes.y - I(tile.y0);
  const S first = depths.first + o.slope_x * S(place.x / 16.0) + o.slope_y * S(place.y / 16.0);
  for (std::size_t begin = 0; begin < hits.count; begin += 16) {
    const I hit(_mm512_load_si512(hits.words + begin));
    const auto whole = [&](const I& v) { return I(_mm512_permutexvar_epi32(hit, v)); };
    const auto real = [&](const S& v) { return as_floats<Lanes>(whole(as_ints<Lanes>(v))); };
    const I column = (hit >> 4) & I(15), row = hit >> 8;
    const I x = whole(left) + column, y = whole(top) + row;
    const S depth = real(first) + real(o.slope_x) * to_floats<Lanes>(column) +
                    real(o.slope_y) * to_floats<Lanes>(row);
    // Past the tile's last pixel, where other lanes' boxes reach.
    const auto beyond = x >= I(tile.x1 - tile.x0) || y >= I(tile.y1 - tile.y0);
    const I block = (x >> 2) + ((y >> 2) << 4), lane = (x & I(3)) + ((y & I(3)) << 2);
    const I at = ((block * I(samples) + I(std::int32_t(sample))) << 4) + lane;
    Found found;
    xsimd::select(beyond, I(kTile * kTile * samples), at).store_aligned(found.at);
    const Keys keys = keys_of(as_ints<Lanes>(min(max(depth, real(depths.min)), real(depths.max))),
                              whole(numbers));
    _mm512_store_si512(found.key, keys.first);
    _mm512_store_si512(found.key + 8, keys.second);
    keep_found(found, std::min<std::size_t>(16, hits.count - begin),
               reinterpret_cast<std::uint64_t*>(tile.nearest));
  }
}

/// Draws a packet of tiny triangles, `numbers`, none of which was clipped.
static void draw_tiny(const Oriented<Lanes>& o, const Ints<Lanes>& numbers, bool cull,
                      const TileTarget& tile) {
  const TinyBoxes boxes = tiny_boxes(o, cull, tile);
  const TinyEdges edges = tiny_edges(o, boxes);
  const TinyDepths depths = tiny_depths(o, boxes);
  Hits hits;
  if (tile.pattern.size() == 1) {
    find_hits<true>(edges, boxes, {0, 0}, hits);
    return draw_hits<true>(hits, 0, o, numbers, boxes, depths, tile);
  }
  for (std::size_t sample = 0; sample < tile.pattern.size(); ++sample) {
    find_hits<false>(edges, boxes, tile.pattern[sample], hits);
    draw_hits<false>(hits, sample, o, numbers, boxes, depths, tile);
  }
}
#endif

}  // namespace lumaknot::fast
