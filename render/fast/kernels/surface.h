/// Interpolation and texture look-up at the points of a packet.
#pragma once

#include "render/fast/kernels/packet.h"

namespace lumaknot::fast {

/// Points to be shaded, one per lane.
template <class A>
struct Points {
  Ints<A> triangle;
  Floats<A> x, y;  ///< image points, in pixels
};

/// Perspective-correct weights of the three corners, and how texture coordinates and 1 / depth
/// depend on the image point.
template <class A>
struct Interpolation {
  std::array<Ints<A>, 3> corners;
  std::array<std::array<Floats<A>, 8>, 3> records;  ///< of the corners
  std::array<Floats<A>, 3> weights;
  Floats<A> depth;
  std::array<Floats<A>, 3> along_x, along_y;  ///< of the weights, per pixel, before they sum to one
  Floats<A> scale;                            ///< that makes them sum to one
};

/// The weights are the areas of the triangles that the point forms with two corners each, times the
/// inverse depth of the third: J. Blinn, "Hyperbolic interpolation", 1992.
template <class A>
Interpolation<A> interpolate(const FrameData& data, const Points<A>& p) {
  using S = Floats<A>;
  Interpolation<A> result;
  result.corners = load_corners<A>(data, p.triangle);
  std::array<S, 3> x, y, w;
  for (std::size_t i = 0; i < 3; ++i) {
    result.records[i] = load_records<A>(data, result.corners[i]);
    x[i] = result.records[i][0] - p.x;
    y[i] = result.records[i][1] - p.y;
    w[i] = result.records[i][2];
  }
  S sum = 0, areas = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const S area = x[j] * y[k] - x[k] * y[j];
    result.weights[i] = area * w[i];
    result.along_x[i] = (y[j] - y[k]) * w[i];
    result.along_y[i] = (x[k] - x[j]) * w[i];
    sum = sum + result.weights[i];
    areas = areas + area;
  }
  result.scale = S(1) / sum;
  result.depth = areas * result.scale;
  for (S& weight : result.weights) weight = weight * result.scale;
  return result;
}

template <class A>
Floats<A> weighted(const std::array<Floats<A>, 3>& weights,
                   const std::array<Floats<A>, 3>& values) {
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
}

/// Member number `member` of each corner's record.
template <class A>
std::array<Floats<A>, 3> corner_members(const Interpolation<A>& at, std::size_t member) {
  return {at.records[0][member], at.records[1][member], at.records[2][member]};
}

/// Texture coordinates and their change per pixel.
template <class A>
struct TextureSite {
  Floats<A> u, v, u_x, u_y, v_x, v_y;
};

template <class A>
TextureSite<A> texture_site(const FrameData& data, const Interpolation<A>& at) {
  using S = Floats<A>;
  const std::array<S, 3> us = corner_members<A>(at, 6);
  const std::array<S, 3> vs = corner_members<A>(at, 7);
  TextureSite<A> site;
  site.u = weighted<A>(at.weights, us);
  site.v = weighted<A>(at.weights, vs);
  if (data.options.filter == Filter::kBilinear) return site;
  // The quotient rule for sum(weight value) / sum(weight).
  const auto change = [&](const std::array<S, 3>& along, const std::array<S, 3>& values,
                          const S& value) {
    const S sum = along[0] + along[1] + along[2];
    return (weighted<A>(along, values) - value * sum) * at.scale;
  };
  site.u_x = change(at.along_x, us, site.u);
  site.u_y = change(at.along_y, us, site.u);
  site.v_x = change(at.along_x, vs, site.v);
  site.v_y = change(at.along_y, vs, site.v);
  return site;
}

/// The lower of two neighbouring texels on one axis, -1 ... size - 1, and the weight of the upper.
template <class A>
struct TexelPair {
  Ints<A> lower;
  Floats<A> weight;
};

/// `coordinate` in [0, 1].
template <class A>
TexelPair<A> texel_pair(const Floats<A>& coordinate, const Ints<A>& size) {
  const Floats<A> texel = coordinate * to_floats<A>(size) - Floats<A>(0.5), lower = floor(texel);
  return {to_ints<A>(lower), texel - lower};
}

/// The color between the texel at `index` and the next.
template <class A>
Vec3<Floats<A>> between_texels(const Mipmap& mipmap, const Ints<A>& index,
                               const Floats<A>& weight) {
  using S = Floats<A>;
  Vec3<S> left, right;
  if (mipmap.floats.empty()) {
    const std::array<Ints<A>, 2> pair = load_rows<A, 2>(mipmap.bytes.data(), index);
    const auto channels = [](const Ints<A>& packed) {
      const Ints<A> byte(255);
      return Vec3<S>{to_floats<A>(packed & byte), to_floats<A>((packed >> 8) & byte),
                     to_floats<A>(packed >> 16)};
    };
    left = channels(pair[0]), right = channels(pair[1]);
  } else {
    const std::array<Ints<A>, 8> pair = load_rows<A, 8>(mipmap.floats.data(), index << 2);
    const auto channels = [&](std::size_t at) {
      return Vec3<S>{as_floats<A>(pair[at]), as_floats<A>(pair[at + 1]),
                     as_floats<A>(pair[at + 2])};
    };
    left = channels(0), right = channels(4);
  }
  return left + (right - left) * weight;
}

/// The levels of a packet's lanes.
template <class A>
struct Levels {
  Ints<A> width, height, stride, first;
};

/// Bilinear look-up.
template <class A>
Vec3<Floats<A>> bilinear(const Mipmap& mipmap, const Floats<A>& u, const Floats<A>& v,
                         const Levels<A>& level) {
  using S = Floats<A>;
  const TexelPair<A> x = texel_pair<A>(u, level.width), y = texel_pair<A>(v, level.height);
  const Ints<A> index = level.first + y.lower * level.stride + x.lower;
  const Vec3<S> below = between_texels<A>(mipmap, index, x.weight);
  const Vec3<S> above = between_texels<A>(mipmap, index + level.stride, x.weight);
  const Vec3<S> color = below + (above - below) * y.weight;
  return mipmap.floats.empty() ? color * S(1.0 / 255) : color;
}

template <class A>
Levels<A> load_levels(const Mipmap& mipmap, const Ints<A>& level) {
  const MipLevels& all = mipmap.levels;
  return {look_up<A>(all.widths, level), look_up<A>(all.heights, level),
          look_up<A>(all.strides, level), look_up<A>(all.firsts, level)};
}

/// The level whose texels are as large as a pixel's footprint: the larger of its two sides, as
/// defined by OpenGL 4.6, 8.14.1.
template <class A>
Floats<A> level_of(const FrameData& data, const TextureSite<A>& site) {
  using S = Floats<A>;
  const MipLevels& levels = data.texture.levels;
  const S width(double(levels.widths[0])), height(double(levels.heights[0]));
  const S x = site.u_x * width, y = site.v_x * height, z = site.u_y * width, w = site.v_y * height;
  const S square = max(max(x * x + y * y, z * z + w * w), S(1e-12));
  const S level = log2(square) * S(0.5);
  return min(max(level, S(0)), S(double(levels.count - 1)));
}

/// Where the texture is read: coordinates in [0, 1], and the level unless there is only one.
template <class A>
struct TexturePlace {
  Floats<A> u, v, level;
};

template <class A>
TexturePlace<A> texture_place(const FrameData& data, const Interpolation<A>& at) {
  using S = Floats<A>;
  const TextureSite<A> site = texture_site<A>(data, at);
  const bool clamped = data.options.wrapping == Wrapping::kClamp;
  const auto wrapped = [&](const S& x) { return saturate(clamped ? x : x - floor(x)); };
  TexturePlace<A> place{wrapped(site.u), wrapped(site.v), S(0)};
  if (data.options.filter == Filter::kTrilinear) place.level = level_of<A>(data, site);
  return place;
}

/// The texture's value there, as the material's form reads it.
template <class A>
Vec3<Floats<A>> texture_at(const FrameData& data, const TexturePlace<A>& place) {
  using S = Floats<A>;
  const Mipmap& texture = data.texture;
  const S &u = place.u, &v = place.v, &level = place.level;
  if (data.options.filter == Filter::kBilinear) {
    return bilinear<A>(texture, u, v, load_levels<A>(texture, Ints<A>(0)));
  }
  const S finer = floor(level);
  const Ints<A> first = to_ints<A>(finer);
  const Vec3<S> near = bilinear<A>(texture, u, v, load_levels<A>(texture, first));
  const S share = level - finer;
  if (!xsimd::any(share.v > 0.0f)) return near;
  const Ints<A> next = xsimd::min(first + Ints<A>(1), Ints<A>(int(texture.levels.count) - 1));
  return near + (bilinear<A>(texture, u, v, load_levels<A>(texture, next)) - near) * share;
}

}  // namespace lumaknot::fast
