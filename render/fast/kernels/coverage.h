/// The third step of a frame: which samples of a tile lie in which triangle, and the nearest one.
#pragma once

#include <algorithm>

#include "render/fast/kernels/nearest.h"
#include "render/fast/kernels/set_up.h"

namespace lumaknot::fast {

/// Up to this size, edge functions have 32 bits within a block; beyond it, rows are cut at the
/// edges.
constexpr int kMedium = 64;

/// A tile's position and the memory it is drawn into.
struct TileTarget {
  int x0, y0, x1, y1;  ///< its pixels, [x0, x1) x [y0, y1)
  std::span<const SamplePlace> pattern;
  std::int32_t* nearest;  ///< TileMemory's
};

/// One triangle of a set-up and the box of pixels of the tile in which its samples may lie.
struct TriangleBox {
  std::uint32_t triangle;
  int x0, y0, x1, y1;  ///< inclusive
  float min, max;      ///< inverse depths of the corners
  float slope_x, slope_y;
  double depth, anchor_x, anchor_y;  ///< of the first corner, in pixels
};

/// Whether a sample on the edge belongs to the triangle: a left one, or a top one.
inline bool owns_samples(std::int64_t dx, std::int64_t dy) { return dy < 0 || (dy == 0 && dx > 0); }

/// The inverse depths of a triangle's samples, block by block, clamped to the corners' range, which
/// rounding may leave.
template <class A>
class BlockDepths {
 public:
  explicit BlockDepths(const TriangleBox& d)
      : lanes_(to_floats<A>(lane_columns<A>()) * Floats<A>(double(d.slope_x)) +
               to_floats<A>(lane_rows<A>()) * Floats<A>(double(d.slope_y))),
        min_(double(d.min)),
        max_(double(d.max)),
        slope_x_(d.slope_x),
        slope_y_(d.slope_y),
        first_(d.depth + slope_x_ * (0.5 - d.anchor_x) + slope_y_ * (0.5 - d.anchor_y)) {}

  /// At the first pixel's centre of the block whose first pixel is (x, y).
  double first(int x, int y) const { return first_ + slope_x_ * x + slope_y_ * y; }

  /// The block's depths, given `first` moved to the sample.
  Floats<A> at(double first, SamplePlace place) const {
    const double moved = first + slope_x_ / 16 * place.x + slope_y_ / 16 * place.y;
    return min(max(Floats<A>(moved) + lanes_, min_), max_);
  }

 private:
  Floats<A> lanes_, min_, max_;
  double slope_x_, slope_y_, first_;
};

/// The edge functions of a small or medium triangle, block by block.
template <class A, class Whole>
class BlockEdges {
 public:
  /// (x, y): the first pixel of the first block. `Whole` has 32 bits for small triangles, else 64.
  BlockEdges(const SetUp<A>& s, std::size_t k, int x, int y) {
    const Whole px = x * kSubpixels + kSubpixels / 2, py = y * kSubpixels + kSubpixels / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t dx = s.dx[i][k], dy = s.dy[i][k];
      first_[i] = dx * (py - s.ay[i][k]) - dy * (px - s.ax[i][k]) - !owns_samples(dx, dy);
      right_[i] = -dy * kSubpixels;
      down_[i] = dx * kSubpixels;
      lanes_[i] = lane_columns<A>() * Ints<A>(right_[i]) + lane_rows<A>() * Ints<A>(down_[i]);
    }
  }

  /// For the block `right` and `down` pixels from the first, at its first pixel's centre. For
  /// medium triangles only the sign is correct: what is cut off is more than it changes in a block.
  std::array<Ints<A>, 3> block(int right, int down) const {
    constexpr Whole kMax = 1 << 30;
    static_assert(std::int64_t(kBlockWidth) * 2 * kMedium * kSubpixels * kSubpixels <= kMax);
    const auto edge = [&](std::size_t i) {
      Whole e = first_[i] + Whole(right_[i]) * right + Whole(down_[i]) * down;
      if constexpr (sizeof(Whole) > 4) e = std::clamp(e, -kMax, kMax);
      return Ints<A>(std::int32_t(e)) + lanes_[i];
    };
    return {edge(0), edge(1), edge(2)};
  }

  /// From a pixel's centre to each sample.
  void sample_steps(std::span<const SamplePlace> pattern, std::int32_t (&steps)[16][3]) const {
    for (std::size_t s = 0; s < pattern.size(); ++s) {
      for (std::size_t i = 0; i < 3; ++i) {
        steps[s][i] = right_[i] / 16 * pattern[s].x + down_[i] / 16 * pattern[s].y;
      }
    }
  }

 private:
  std::array<Whole, 3> first_;
  std::array<std::int32_t, 3> right_, down_;
  std::array<Ints<A>, 3> lanes_;
};

/// All samples of a small or medium triangle; `one`: one per pixel, at its centre. Missed blocks
/// and samples are not skipped: an unpredictable branch takes longer.
template <class A, class Whole, bool one>
void draw_blocks(const SetUp<A>& s, std::size_t k, const TriangleBox& d, const TileTarget& tile) {
  const int x0 = d.x0 & -kBlockWidth, y0 = d.y0 & -kBlockHeight<A>;
  const std::size_t samples = one ? 1 : tile.pattern.size();
  const BlockEdges<A, Whole> edges(s, k, x0, y0);
  const BlockDepths<A> depths(d);
  std::int32_t steps[16][3];
  if constexpr (!one) edges.sample_steps(tile.pattern, steps);
  for (int y = y0; y <= d.y1; y += kBlockHeight<A>) {
    for (int x = x0; x <= d.x1; x += kBlockWidth) {
      std::size_t at = block_begin<A>(x - tile.x0, y - tile.y0) * samples;
      const std::array<Ints<A>, 3> e = edges.block(x - x0, y - y0);
      const double first = depths.first(x, y);
      for (std::size_t i = 0; i < samples; ++i, at += Ints<A>::size) {
        std::array<Ints<A>, 3> moved = e;
        if constexpr (!one) {
          for (std::size_t j = 0; j < 3; ++j) moved[j] = e[j] + Ints<A>(steps[i][j]);
        }
        Nearest<A>::keep((moved[0] | moved[1] | moved[2]) >= Ints<A>(0),
                         depths.at(first, one ? SamplePlace{0, 0} : tile.pattern[i]), d.triangle,
                         tile.nearest + 2 * at);
      }
    }
  }
}

/// x / y rounded down, y > 0.
inline std::int64_t floor_divided(std::int64_t x, std::int64_t y) { return x / y - (x % y < 0); }

/// The pixels [first, last] of a row in which edge functions of 64 bits are not negative.
struct Span {
  std::int64_t first, last;

  /// `e` at pixel 0 and its change per pixel.
  void cut(std::int64_t e, std::int64_t growth) {
    if (growth > 0) {
      first = std::max(first, -floor_divided(e, growth));
    } else if (growth < 0) {
      last = std::min(last, floor_divided(e, -growth));
    } else if (e < 0) {
      last = first - 1;
    }
  }
};

/// The pixels of the row `y` whose sample number `sample` is in a large triangle, exactly.
template <class A>
Span row_span(const SetUp<A>& s, std::size_t k, const TriangleBox& d, SamplePlace place, int y) {
  if (y < d.y0 || y > d.y1) return {1, 0};
  const std::int64_t px = d.x0 * kSubpixels + kSubpixels / 2 + place.x * (kSubpixels / 16);
  const std::int64_t py = y * kSubpixels + kSubpixels / 2 + place.y * (kSubpixels / 16);
  Span span{0, d.x1 - d.x0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t dx = s.dx[i][k], dy = s.dy[i][k];
    span.cut(dx * (py - s.ay[i][k]) - dy * (px - s.ax[i][k]) - !owns_samples(dx, dy),
             -dy * kSubpixels);
  }
  return {d.x0 + span.first, d.x0 + span.last};
}

/// Sample number `sample` of all pixels of a large triangle.
template <class A>
void draw_large(const SetUp<A>& s, std::size_t k, const TriangleBox& d, const TileTarget& tile,
                std::size_t sample) {
  const SamplePlace place = tile.pattern[sample];
  const BlockDepths<A> depths(d);
  for (int y = d.y0 & -kBlockHeight<A>; y <= d.y1; y += kBlockHeight<A>) {
    std::int32_t firsts[Ints<A>::size], lasts[Ints<A>::size];
    int first = d.x1 + 1, last = d.x0 - 1;
    for (int row = 0; row < kBlockHeight<A>; ++row) {
      const Span span = row_span<A>(s, k, d, place, y + row);
      const bool empty = span.first > span.last;
      for (int i = row * kBlockWidth; i < (row + 1) * kBlockWidth; ++i) {
        firsts[i] = empty ? 1 : std::int32_t(span.first);
        lasts[i] = empty ? 0 : std::int32_t(span.last);
      }
      if (empty) continue;
      first = std::min(first, int(span.first));
      last = std::max(last, int(span.last));
    }
    const Ints<A> from = Ints<A>::load_unaligned(firsts), to = Ints<A>::load_unaligned(lasts);
    for (int x = first & -kBlockWidth; x <= last; x += kBlockWidth) {
      const Ints<A> columns = lane_columns<A>() + Ints<A>(x);
      const std::size_t at =
          block_begin<A>(x - tile.x0, y - tile.y0) * tile.pattern.size() + sample * Ints<A>::size;
      Nearest<A>::keep(columns >= from && columns <= to && from <= to,
                       depths.at(depths.first(x, y), place), d.triangle, tile.nearest + 2 * at);
    }
  }
}

/// The part of a triangle's box that lies in the tile; empty where x0 > x1 or y0 > y1.
template <class A>
TriangleBox drawn_part(const SetUp<A>& s, std::size_t k, std::uint32_t triangle,
                       const TileTarget& tile) {
  const bool centres = tile.pattern.size() == 1;
  TriangleBox d{};
  d.triangle = triangle;
  d.x0 = std::max(tile.x0, first_pixel<A>(s.min[0][k], centres));
  d.y0 = std::max(tile.y0, first_pixel<A>(s.min[1][k], centres));
  d.x1 = std::min(tile.x1 - 1, last_pixel<A>(s.max[0][k], centres));
  d.y1 = std::min(tile.y1 - 1, last_pixel<A>(s.max[1][k], centres));
  d.min = std::min({s.depth[0][k], s.depth[1][k], s.depth[2][k]});
  d.max = std::max({s.depth[0][k], s.depth[1][k], s.depth[2][k]});
  d.slope_x = s.slope_x[k];
  d.slope_y = s.slope_y[k];
  d.depth = s.depth[0][k];
  d.anchor_x = double(s.ax[0][k]) / kSubpixels;
  d.anchor_y = double(s.ay[0][k]) / kSubpixels;
  return d;
}

/// Draws one triangle of a set-up.
template <class A>
void draw_triangle(SetUp<A>& s, std::size_t k, std::uint32_t triangle, bool cull,
                   const TileTarget& tile) {
  const auto within = [&](int pixels) {
    return s.max[0][k] - s.min[0][k] <= pixels * kSubpixels &&
           s.max[1][k] - s.min[1][k] <= pixels * kSubpixels;
  };
  const bool small = within(kSmall), one = tile.pattern.size() == 1;
  const std::int64_t area = small ? s.area[k] : set_up_large<A>(s, k);
  if (area == 0 || (cull && area > 0)) return;
  const TriangleBox d = drawn_part<A>(s, k, triangle, tile);
  if (d.x0 > d.x1 || d.y0 > d.y1) return;
  if (small && one) return draw_blocks<A, std::int32_t, true>(s, k, d, tile);
  if (small) return draw_blocks<A, std::int32_t, false>(s, k, d, tile);
  if (within(kMedium)) return draw_blocks<A, std::int64_t, false>(s, k, d, tile);
  for (std::size_t sample = 0; sample < tile.pattern.size(); ++sample) {
    draw_large<A>(s, k, d, tile, sample);
  }
}

}  // namespace lumaknot::fast
