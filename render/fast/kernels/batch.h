/// Points of a tile shaded together, packet by packet.
#pragma once

#include <span>

#include "render/fast/kernels/surface.h"

// Inlines everything a function calls: calls would pass registers through memory. Not with
// sanitizers, whose checks make such a function take minutes to compile.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LUMAKNOT_FLAT
#else
#define LUMAKNOT_FLAT __attribute__((flatten))
#endif

namespace lumaknot::fast {

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
  to.parameters = ModelParameters<S>::from([&](std::size_t i) { return S(from.parameters.at(i)); });
  to.ambient = vec(from.ambient);
  to.diffuse = vec(from.diffuse);
  to.specular = vec(from.specular);
  to.emissive = vec(from.emissive);
  to.luma_offset = S(from.luma_offset);
  return to;
}

/// Shades points of the frame into colours of a tile. Points are collected until there are several
/// packets; then each stage runs for all of them, so that its few numbers stay in registers and
/// packets don't wait for each other's memory.
template <class A>
class ShadingBatch {
 public:
  using S = Floats<A>;
  static constexpr std::size_t kWidth = S::kWidth;

  ShadingBatch(const FrameData& data, const Lighting<S>& lighting)
      : data_(data), lighting_(lighting) {}

  /// Points of a block, each covering its whole pixel; `colors` are set.
  void add_block(const Points<A>& points, float* colors) {
    Packet& packet = packets_[count_];
    packet.points = points;
    packet.block = colors;
    if (++count_ == kPackets) shade();
  }

  /// A point of any pixel that stands for `share` of its samples; its colour is added to `color`.
  void add_point(std::int32_t triangle, float x, float y, float share, float* color) {
    const std::size_t k = waiting_.count++;
    waiting_.triangle[k] = triangle;
    waiting_.x[k] = x;
    waiting_.y[k] = y;
    waiting_.share[k] = share;
    waiting_.color[k] = color;
    if (waiting_.count == kWidth) flush();
  }

  /// Shades what is left.
  void finish() {
    if (waiting_.count > 0) flush();
    shade();
  }

 private:
  /// Points of several pixels.
  struct Lanes {
    std::size_t count = 0;
    std::int32_t triangle[kWidth];
    float x[kWidth], y[kWidth];  ///< image points
    float share[kWidth];         ///< of the pixel's samples
    float* color[kWidth];        ///< the pixel's r; each further channel kWidth farther on
  };

  /// The data passed from stage to stage.
  struct Packet {
    Points<A> points;
    S depth;
    Vec3<S> normal;
    TexturePlace<A> place;
    Terms<S> terms;
    Vec3<S> color;
    float* block;  ///< nullptr: `lanes`
    Lanes lanes;
  };

  void flush() {
    for (std::size_t k = waiting_.count; k < kWidth; ++k) {
      waiting_.triangle[k] = waiting_.triangle[0];
      waiting_.x[k] = waiting_.x[0];
      waiting_.y[k] = waiting_.y[0];
    }
    Packet& packet = packets_[count_];
    packet.points = {Ints<A>::load_unaligned(waiting_.triangle), S::load(waiting_.x),
                     S::load(waiting_.y)};
    packet.block = nullptr;
    packet.lanes = waiting_;
    waiting_.count = 0;
    if (++count_ == kPackets) shade();
  }

  void shade() {
    interpolate_all();
    read_textures();
    light_all();
    for (const Packet& packet : std::span(packets_, count_)) put(packet);
    count_ = 0;
  }

  LUMAKNOT_FLAT void interpolate_all() {
    for (Packet& packet : std::span(packets_, count_)) {
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

  LUMAKNOT_FLAT void read_textures() {
    for (Packet& packet : std::span(packets_, count_)) {
      packet.color = data_.texture.levels.count > 0 ? texture_at<A>(data_, packet.place)
                                                    : constant_vec<S>(data_.texture.color);
    }
  }

  LUMAKNOT_FLAT void light_all() {
    for (Packet& packet : std::span(packets_, count_)) {
      if (data_.terms.empty()) {
        packet.terms = surface_terms(surface_point(packet), lighting_.eye_position,
                                     lighting_.lights, lighting_.parameters, data_.shot.material);
      }
      packet.color = stage_color<S>(packet.color, packet.terms, lighting_, data_.shot);
    }
  }

  /// The position on the ray through the image point.
  SurfacePoint<S> surface_point(const Packet& packet) const {
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

  static void put(const Packet& packet) {
    if (float* to = packet.block) {
      packet.color.x.store(to);
      packet.color.y.store(to + kWidth);
      packet.color.z.store(to + 2 * kWidth);
      S(1).store(to + 3 * kWidth);
      return;
    }
    float r[kWidth], g[kWidth], b[kWidth];
    packet.color.x.store(r);
    packet.color.y.store(g);
    packet.color.z.store(b);
    for (std::size_t k = 0; k < packet.lanes.count; ++k) {
      float* to = packet.lanes.color[k];
      const float share = packet.lanes.share[k];
      to[0] += r[k] * share;
      to[kWidth] += g[k] * share;
      to[2 * kWidth] += b[k] * share;
      to[3 * kWidth] += share;
    }
  }

  static constexpr std::size_t kPackets = 8;

  const FrameData& data_;
  const Lighting<S>& lighting_;
  Lanes waiting_;
  Packet packets_[kPackets];
  std::size_t count_ = 0;
};

}  // namespace lumaknot::fast
