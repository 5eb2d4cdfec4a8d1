#ifndef KB
#define KB 8
#endif
/// The last steps of a frame, a tile at a time: what is nearest, its colour, and the picture.
#pragma once

#include "render/kernels/coverage.h"
#include "render/kernels/surface.h"
#include "render/kernels/tiny.h"

// All that a function calls in it: calls would pass registers through memory. With the checks of
// sanitizers such a function takes minutes to compile.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LUMAKNOT_FLAT
#else
#define LUMAKNOT_FLAT __attribute__((flatten))
#endif

namespace lumaknot {

/// Points of a tile that wait to be shaded together.
template <class A>
struct Waiting {
  static constexpr std::size_t kWidth = Floats<A>::kWidth;
  std::size_t count = 0;
  std::int32_t triangle[kWidth];
  float x[kWidth], y[kWidth];  ///< image points
  float share[kWidth];         ///< of the pixel's samples
  float* color[kWidth];        ///< of the pixel
};

/// The scene's numbers as packets.
template <class A>
Lighting<Floats<A>> packed(const Lighting<double>& from) {
  using S = Floats<A>;
  const auto vec = [](const Vec3d& v) { return Vec3<S>{S(v.x), S(v.y), S(v.z)}; };
  Lighting<S> to;
  to.eye_position = vec(from.eye_position);
  for (const LightNumbers<double>& l : from.lights) {
    const bool weakens = l.constant != 1 || l.linear != 0 || l.quadratic != 0;
    to.lights.push_back({l.has_position, weakens, l.has_cone, vec(l.position), vec(l.direction),
                         vec(l.color), S(l.constant), S(l.linear), S(l.quadratic), S(l.cos_outer),
                         S(l.cone_scale)});
  }
  const ModelNumbers<double>& m = from.model;
  to.model = {S(m.shininess), S(m.roughness), S(m.reflectance), S(m.darkness)};
  to.ambient = vec(from.ambient);
  to.diffuse = vec(from.diffuse);
  to.specular = vec(from.specular);
  to.emissive = vec(from.emissive);
  to.luma_offset = S(from.luma_offset);
  return to;
}

/// Draws one tile.
template <class A>
class TilePainter {
 public:
  using S = Floats<A>;

  TilePainter(const FrameData& data, const Lighting<S>& lighting, TileMemory& memory, int tile)
      : data_(data), lighting_(lighting), memory_(memory) {
    const int x = tile % data.columns * kTile, y = tile / data.columns * kTile;
    target_ = {x,
               y,
               std::min(x + kTile, data.width),
               std::min(y + kTile, data.height),
               data.pattern,
               memory.depths.data(),
               memory.seen.data()};
    for (std::size_t i = 0; i < data.pattern.size(); ++i) {
      places_[i][0] = 0.5f + float(data.pattern[i].x) / 16;
      places_[i][1] = 0.5f + float(data.pattern[i].y) / 16;
    }
  }

  void paint(int tile) {
    bool any = false;
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
  struct Lane_packet {
    Points<A> points;
    S depth;
    Vec3<S> normal;
    TexturePlace<A> place;
    Terms<S> terms;
    Vec3<S> color;
    float* block;
    Waiting<A> lanes;
  };
  static constexpr std::size_t kBatch = KB;
  Lane_packet batch_[kBatch];
  std::size_t batch_count_ = 0;
  void clear() {
    std::fill_n(memory_.depths.data(), memory_.depths.size(), 0);
    std::fill_n(memory_.seen.data(), memory_.seen.size(), kNothing);
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

  /// What all samples of a block's pixels see, or kMixed.
  Ints<A> uniform_of(const std::int32_t* block) const {
    const Ints<A> first = Ints<A>::load_aligned(block);
    Ints<A> uniform = first;
    for (std::size_t s = 1; s < data_.pattern.size(); ++s) {
      const Ints<A> other = Ints<A>::load_aligned(block + s * S::kWidth);
      uniform = xsimd::select(other == first, uniform, Ints<A>(kMixed));
    }
    return uniform;
  }

  /// Block by block; those that see nothing are left out.
  void shade() {
    constexpr int kBlocks = kTile * kTile / int(S::kWidth), kAcross = kTile / kBlockWidth;
    Waiting<A> waiting;
    for (int block = 0; block < kBlocks; ++block) {
      const std::size_t begin = std::size_t(block) * S::kWidth;
      const std::int32_t* samples = memory_.seen.data() + begin * data_.pattern.size();
      const Ints<A> uniform = uniform_of(samples);
      const bool any = xsimd::any(uniform != Ints<A>(kNothing));
      memory_.touched[std::size_t(block)] = any;
      if (!any) continue;
      const int x = target_.x0 + block % kAcross * kBlockWidth;
      const int y = target_.y0 + block / kAcross * kBlockHeight<A>;
      float* colors = memory_.colors.data() + begin * 4;
      if (xsimd::all(uniform >= Ints<A>(0))) {
        shade_whole(uniform, x, y, colors);
      } else {
        add_block(waiting, uniform, x, y, samples, colors);
      }
    }
    flush(waiting);
    shade_batch();
  }

  /// A block each of whose pixels sees one triangle.
  void shade_whole(const Ints<A>& seen, int x, int y, float* colors) {
    Lane_packet& packet = batch_[batch_count_];
    packet.points = {seen, to_floats<A>(lane_columns<A>()) + S(x + 0.5),
                     to_floats<A>(lane_rows<A>()) + S(y + 0.5)};
    packet.block = colors;
    if (++batch_count_ == kBatch) shade_batch();
  }

  void put_block(const Lane_packet& packet) const {
    alignas(64) float r[S::kWidth], g[S::kWidth], b[S::kWidth];
    packet.color.x.store(r);
    packet.color.y.store(g);
    packet.color.z.store(b);
    float* colors = packet.block;
    for (std::size_t i = 0; i < S::kWidth; ++i) {
      colors[4 * i] = r[i];
      colors[4 * i + 1] = g[i];
      colors[4 * i + 2] = b[i];
      colors[4 * i + 3] = 1;
    }
  }

  void put_lanes(const Lane_packet& packet) const {
    float r[S::kWidth], g[S::kWidth], b[S::kWidth];
    packet.color.x.store(r);
    packet.color.y.store(g);
    packet.color.z.store(b);
    for (std::size_t k = 0; k < packet.lanes.count; ++k) {
      float* to = packet.lanes.color[k];
      const float share = packet.lanes.share[k];
      to[0] += r[k] * share;
      to[1] += g[k] * share;
      to[2] += b[k] * share;
      to[3] += share;
    }
  }

  void add_block(Waiting<A>& waiting, const Ints<A>& uniform, int x, int y,
                 const std::int32_t* samples, float* colors) {
    std::fill_n(colors, S::kWidth * 4, 0.0f);
    std::int32_t seen[S::kWidth];
    uniform.store_unaligned(seen);
    for (int lane = 0; lane < int(S::kWidth); ++lane) {
      const Place place{x + lane % kBlockWidth, y + lane / kBlockWidth, colors + lane * 4};
      if (seen[lane] == kMixed) {
        add_mixed(waiting, place, samples + lane);
      } else if (seen[lane] != kNothing) {
        add(waiting, seen[lane], place, 0.5f, 0.5f, 1);
      }
    }
  }

  struct Place {
    int x, y;      ///< pixel
    float* color;  ///< in the tile's memory
  };

  /// The point of a pixel where `triangle` is shaded, from the pixel's corner.
  void add(Waiting<A>& waiting, std::int32_t triangle, const Place& place, float dx, float dy,
           float share) {
    const std::size_t k = waiting.count++;
    waiting.triangle[k] = triangle;
    waiting.x[k] = float(place.x) + dx;
    waiting.y[k] = float(place.y) + dy;
    waiting.share[k] = share;
    waiting.color[k] = place.color;
    if (waiting.count == Waiting<A>::kWidth) flush(waiting);
  }

  /// Each triangle that samples of the pixel see, at the middle of those samples, so that nothing
  /// is extrapolated.
  void add_mixed(Waiting<A>& waiting, const Place& place, const std::int32_t* samples) {
    const std::size_t count = data_.pattern.size();
    std::int32_t seen[16];
    for (std::size_t s = 0; s < count; ++s) seen[s] = samples[s * S::kWidth];
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
      add(waiting, triangle, place, x * scale, y * scale, found / float(count));
    }
  }

  void flush(Waiting<A>& waiting) {
    if (waiting.count == 0) return;
    for (std::size_t k = waiting.count; k < Waiting<A>::kWidth; ++k) {
      waiting.triangle[k] = waiting.triangle[0];
      waiting.x[k] = waiting.x[0];
      waiting.y[k] = waiting.y[0];
    }
    Lane_packet& packet = batch_[batch_count_];
    packet.points = {Ints<A>::load_unaligned(waiting.triangle), S::load(waiting.x), S::load(waiting.y)};
    packet.block = nullptr;
    packet.lanes = waiting;
    waiting.count = 0;
    if (++batch_count_ == kBatch) shade_batch();
  }

  /// Stage by stage, each for all packets: a stage's few numbers stay in registers, and packets
  /// don't wait for each other.
  void shade_batch() {
    interpolate_batch();
    texture_batch();
    light_batch();
    for (std::size_t i = 0; i < batch_count_; ++i) {
      const Lane_packet& packet = batch_[i];
      if (packet.block) put_block(packet); else put_lanes(packet);
    }
    batch_count_ = 0;
  }

  LUMAKNOT_FLAT void interpolate_batch() {
    for (std::size_t i = 0; i < batch_count_; ++i) {
      Lane_packet& packet = batch_[i];
      const Interpolation<A> at = interpolate<A>(data_, packet.points);
      packet.depth = at.depth;
      if (data_.texture.levels.count > 0) packet.place = texture_place<A>(data_, at);
      if (data_.terms.empty()) {
        packet.normal = normal_of(at);
      } else {
        packet.terms = vertex_terms(at);
      }
    }
  }

  LUMAKNOT_FLAT void texture_batch() {
    for (std::size_t i = 0; i < batch_count_; ++i) {
      Lane_packet& packet = batch_[i];
      packet.color = data_.texture.levels.count > 0 ? texture_at<A>(data_, packet.place) : constant_vec<S>(data_.texture.color);
    }
  }

  LUMAKNOT_FLAT void light_batch() {
    for (std::size_t i = 0; i < batch_count_; ++i) {
      Lane_packet& packet = batch_[i];
      if (data_.terms.empty()) {
        packet.terms = surface_terms(surface_point(packet), lighting_.eye_position, lighting_.lights, lighting_.model, data_.shot.material);
      }
      packet.color = stage_color<S>(packet.color, packet.terms, lighting_, data_.shot);
    }
  }

  /// The position by the ray through the image point.
  SurfacePoint<S> surface_point(const Lane_packet& packet) const {
    const Points<A>& p = packet.points;
    const Vec3<S> ray = constant_vec<S>(data_.corner_ray) + constant_vec<S>(data_.ray_x) * p.x +
                        constant_vec<S>(data_.ray_y) * p.y;
    return {lighting_.eye_position + ray * packet.depth, packet.normal};
  }

  Vec3<S> normal_of(const Interpolation<A>& at) const {
    const auto normal = [&](std::size_t c) {
      return weighted<A>(at.weights, corner_members<A>(at, 3 + c));
    };
    return {normal(0), normal(1), normal(2)};
  }

  Terms<S> vertex_terms(const Interpolation<A>& at) const {
    std::array<S, 6> sums;
    const auto* terms = reinterpret_cast<const std::int32_t*>(data_.terms.data());
    for (int c = 0; c < 6; ++c) {
      std::array<S, 3> values;
      for (std::size_t i = 0; i < 3; ++i) {
        values[i] = as_floats<A>(gather(terms + c, at.corners[i] * Ints<A>(6)));
      }
      sums[std::size_t(c)] = weighted<A>(at.weights, values);
    }
    return {{sums[0], sums[1], sums[2]}, {sums[3], sums[4], sums[5]}};
  }

  /// The tile's colours into the picture; nothing where no block was touched.
  template <class Pixel>
  void put(Grid<Pixel>& picture, bool any) const {
    const int width = target_.x1 - target_.x0;
    for (int y = target_.y0; y < target_.y1; ++y) {
      Pixel* to = &picture.at(target_.x0, y);
      std::fill_n(to, width, Pixel{});
      if (!any) continue;
      const int row = (y - target_.y0) % kBlockHeight<A> * kBlockWidth;
      for (int x = 0; x < width; x += kBlockWidth) {
        const std::size_t begin = block_begin<A>(x, y - target_.y0);
        if (!memory_.touched[begin / S::kWidth]) continue;
        Pixel pixels[kBlockWidth];
        convert(memory_.colors.data() + (begin + std::size_t(row)) * 4, pixels);
        std::copy_n(pixels, std::min(kBlockWidth, width - x), to + x);
      }
    }
  }

  /// Each limited to [0, 1], times 255; NaN becomes 0.
  static void convert(const float* from, Rgba8* to) {
    for (std::size_t i = 0; i < 4 * kBlockWidth; i += S::kWidth) {
      const S limited = saturate(S::load(from + i));
      const S number = select_less(limited, S(2), limited, S(0));
      store_bytes(to_ints<A>(number * S(255) + S(0.5)), reinterpret_cast<std::uint8_t*>(to) + i);
    }
  }

  static void convert(const float* from, RgbaPixel* to) {
    for (int i = 0; i < kBlockWidth; ++i, from += 4) to[i] = {{from[0], from[1], from[2]}, from[3]};
  }

  const FrameData& data_;
  const Lighting<S>& lighting_;
  TileMemory& memory_;
  TileTarget target_;
  bool tiny_ = data_.pattern.size() == 1 && data_.clipped.empty();
  float places_[16][2];  ///< of the samples, from a pixel's corner
};

}  // namespace lumaknot
