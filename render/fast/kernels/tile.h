/// The last steps of a frame, tile by tile: the nearest triangles, their colours, and the picture.
#pragma once

#include "render/fast/kernels/batch.h"
#include "render/fast/kernels/tiny.h"

namespace lumaknot::fast {

/// Draws one tile.
template <class A>
class TilePainter {
 public:
  using S = Floats<A>;

  TilePainter(const FrameData& data, const Lighting<S>& lighting, TileMemory& memory, int tile)
      : data_(data), memory_(memory), batch_(data, lighting) {
    const int x = tile % data.columns * kTile, y = tile / data.columns * kTile;
    target_ = {x,
               y,
               std::min(x + kTile, data.width),
               std::min(y + kTile, data.height),
               data.pattern,
               memory.nearest.data()};
    for (std::size_t i = 0; i < data.pattern.size(); ++i) {
      places_[i][0] = 0.5f + float(data.pattern[i].x) / 16;
      places_[i][1] = 0.5f + float(data.pattern[i].y) / 16;
    }
  }

  void paint(int tile) {
    bool any = false;
    tiny_ = !has_pieces(tile);
    for (const Run& run : data_.runs) {
      const std::uint32_t begin = run.begins[std::size_t(tile)];
      const std::uint32_t end = run.begins[std::size_t(tile) + 1];
      if (begin == end) continue;
      if (!any) clear();
      any = true;
      cover(run.listed.data() + begin, end - begin);
    }
    if (any) shade();
    if (data_.bytes) {
      put(*data_.bytes, any);
    } else {
      put(*data_.floats, any);
    }
  }

 private:
  /// Whether some of the tile's triangles come from clipping: their numbers don't rise with their
  /// order, by which draw_tiny() decides which of two at the same depth comes later.
  bool has_pieces(int tile) const {
    if (data_.clipped.empty()) return false;
    return std::ranges::any_of(data_.runs, [&](const Run& run) {
      const auto begin = run.listed.begin() + std::ptrdiff_t(run.begins[std::size_t(tile)]);
      const auto end = run.listed.begin() + std::ptrdiff_t(run.begins[std::size_t(tile) + 1]);
      return std::any_of(begin, end, [&](std::uint32_t t) { return t >= data_.triangle_count; });
    });
  }

  void clear() {
    for (std::size_t i = 0; i < memory_.nearest.size(); i += 2 * S::kWidth) {
      Nearest<A>::clear(memory_.nearest.data() + i);
    }
  }

  LUMAKNOT_FLAT void cover(const std::uint32_t* triangles, std::size_t count) {
    constexpr std::size_t kWidth = S::kWidth;
    for (std::size_t i = 0; i < count; i += kWidth) {
      std::int32_t packet[kWidth];
      const std::size_t last = std::min(kWidth, count - i);
      for (std::size_t k = 0; k < kWidth; ++k) {
        packet[k] = std::int32_t(triangles[i + std::min(k, last - 1)]);
      }
      const Ints<A> numbers = Ints<A>::load_unaligned(packet);
      const Oriented<A> o = oriented<A>(data_, numbers);
      if (tiny_ && are_tiny(o)) {
        draw_tiny(o, numbers, data_.options.cull_back_faces, target_);
        continue;
      }
      SetUp<A> s = set_up<A>(o);
      for (std::size_t k = 0; k < last; ++k) {
        draw_triangle<A>(s, k, triangles[i + k], data_.options.cull_back_faces, target_);
      }
    }
  }

  /// What all samples of a block see, or kMixed.
  Ints<A> uniform_of(const std::int32_t* block) const {
    const Ints<A> first = Nearest<A>::seen(block);
    Ints<A> uniform = first;
    for (std::size_t s = 1; s < data_.pattern.size(); ++s) {
      const Ints<A> other = Nearest<A>::seen(block + 2 * s * S::kWidth);
      uniform = xsimd::select(other == first, uniform, Ints<A>(kMixed));
    }
    return uniform;
  }

  /// Block by block, without those that see nothing.
  void shade() {
    constexpr int kBlocks = kTile * kTile / int(S::kWidth), kAcross = kTile / kBlockWidth;
    for (int block = 0; block < kBlocks; ++block) {
      const std::size_t begin = std::size_t(block) * S::kWidth;
      const std::int32_t* samples = memory_.nearest.data() + 2 * begin * data_.pattern.size();
      const Ints<A> uniform = uniform_of(samples);
      const bool any = xsimd::any(uniform != Ints<A>(kNothing));
      memory_.touched[std::size_t(block)] = any;
      if (!any) continue;
      const int x = target_.x0 + block % kAcross * kBlockWidth;
      const int y = target_.y0 + block / kAcross * kBlockHeight<A>;
      float* colors = memory_.colors.data() + begin * 4;
      if (xsimd::all(uniform >= Ints<A>(0))) {
        batch_.add_block({uniform, to_floats<A>(lane_columns<A>()) + S(x + 0.5),
                          to_floats<A>(lane_rows<A>()) + S(y + 0.5)},
                         colors);
      } else {
        add_pixels(uniform, x, y, samples, colors);
      }
    }
    batch_.finish();
  }

  /// A block some of whose pixels see nothing or several triangles.
  void add_pixels(const Ints<A>& uniform, int x, int y, const std::int32_t* samples,
                  float* colors) {
    std::fill_n(colors, S::kWidth * 4, 0.0f);
    std::int32_t seen[S::kWidth];
    uniform.store_unaligned(seen);
    for (int lane = 0; lane < int(S::kWidth); ++lane) {
      const Place place{x + lane % kBlockWidth, y + lane / kBlockWidth, colors + lane};
      if (seen[lane] == kMixed) {
        add_mixed(place, samples, lane);
      } else if (seen[lane] != kNothing) {
        add(seen[lane], place, 0.5f, 0.5f, 1);
      }
    }
  }

  struct Place {
    int x, y;      ///< pixel
    float* color;  ///< in the tile's memory
  };

  /// The point of a pixel where `triangle` is shaded, relative to the pixel's corner.
  void add(std::int32_t triangle, const Place& place, float dx, float dy, float share) {
    batch_.add_point(triangle, float(place.x) + dx, float(place.y) + dy, share, place.color);
  }

  /// Each triangle that samples of the pixel see is shaded at the mean of those samples, so that
  /// nothing is extrapolated.
  void add_mixed(const Place& place, const std::int32_t* samples, int lane) {
    const std::size_t count = data_.pattern.size();
    std::int32_t seen[16];
    for (std::size_t s = 0; s < count; ++s)
      seen[s] = Nearest<A>::seen(samples + 2 * s * S::kWidth, lane);
    for (std::size_t s = 0; s < count; ++s) {
      const std::int32_t triangle = seen[s];
      if (triangle == kNothing) continue;
      float found = 0, x = 0, y = 0;
      for (std::size_t r = s; r < count; ++r) {
        const bool same = seen[r] == triangle;
        found += same ? 1.0f : 0.0f;
        x += same ? places_[r][0] : 0.0f;
        y += same ? places_[r][1] : 0.0f;
        seen[r] = same ? kNothing : seen[r];
      }
      const float scale = 1 / found;
      add(triangle, place, x * scale, y * scale, found / float(count));
    }
  }

  /// Copies the tile's colours into the picture; blocks not touched become empty.
  template <class Pixel>
  void put(Grid<Pixel>& picture, bool any) const {
    for (int y = target_.y0; y < target_.y1; y += kBlockHeight<A>) {
      for (int x = target_.x0; x < target_.x1; x += kBlockWidth) {
        const std::size_t begin = block_begin<A>(x - target_.x0, y - target_.y0);
        alignas(64) std::array<Pixel, S::kWidth> pixels{};
        if (any && memory_.touched[begin / S::kWidth]) {
          convert(memory_.colors.data() + begin * 4, pixels);
        }
        const int columns = std::min(kBlockWidth, target_.x1 - x);
        const int rows = std::min(kBlockHeight<A>, target_.y1 - y);
        for (int row = 0; row < rows; ++row) {
          const Pixel* from = pixels.data() + row * kBlockWidth;
          Pixel* to = &picture.at(x, y + row);
          if (columns == kBlockWidth) {
            std::copy_n(from, kBlockWidth, to);  // a size known to the compiler
          } else {
            std::copy_n(from, columns, to);
          }
        }
      }
    }
  }

  /// Each limited to [0, 1], times 255; NaN becomes 0. Packed into integers, stored lowest byte
  /// first.
  static void convert(const float* from, std::array<Rgba8, S::kWidth>& to) {
    static_assert(sizeof(Rgba8) == sizeof(std::int32_t));
    Ints<A> packed(0);
    for (std::size_t c = 0; c < 4; ++c) {
      const S limited = saturate(S::load(from + c * S::kWidth));
      const S number = select_less(limited, S(2), limited, S(0));
      packed = packed | to_ints<A>(number * S(255) + S(0.5)) << int(8 * c);
    }
    packed.store_aligned(reinterpret_cast<std::int32_t*>(to.data()));
  }

  static void convert(const float* from, std::array<RgbaPixel, S::kWidth>& to) {
    constexpr std::size_t kWidth = S::kWidth;
    for (std::size_t i = 0; i < kWidth; ++i) {
      to[i] = {{from[i], from[kWidth + i], from[2 * kWidth + i]}, from[3 * kWidth + i]};
    }
  }

  const FrameData& data_;
  TileMemory& memory_;
  ShadingBatch<A> batch_;
  TileTarget target_;
  bool tiny_ = true;     ///< draw_tiny() may draw tiny packets
  float places_[16][2];  ///< of the samples, from a pixel's corner
};

}  // namespace lumaknot::fast
