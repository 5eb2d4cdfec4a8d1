/// The first step of a frame: vertices projected onto the image, and with ShadingFrequency::kVertex
/// lit.
#pragma once

#include <cmath>

#include "render/fast/kernels/packet.h"

namespace lumaknot::fast {

/// Doubles per packet.
template <class A>
using Doubles = xsimd::batch<double, A>;

/// Image points of several vertices, and snapped ones: integers, or SnappedPoint's marks for those
/// outside.
template <class A>
struct ImagePoints {
  static constexpr std::size_t kWidth = Doubles<A>::size;
  double x[kWidth], y[kWidth], inverse_depth[kWidth];
  double snapped_x[kWidth], snapped_y[kWidth];
  bool all_inside;
};

/// The image points of the vertices from `i` on.
template <class A>
ImagePoints<A> image_points(const FrameData& data, std::size_t i) {
  using S = Doubles<A>;
  const Vec3<S> world{S::load_unaligned(&data.xs[i]), S::load_unaligned(&data.ys[i]),
                      S::load_unaligned(&data.zs[i])};
  const Vec3<S> image = data.projection.to_image(data.projection.to_view(world));
  const auto inside = image.z >= S(data.near) && xsimd::abs(image.x) <= S(kGuard) &&
                      xsimd::abs(image.y) <= S(kGuard);  // false for NaN
  const auto snapped = [](const S& v) { return xsimd::floor(v * S(kSubpixels) + S(0.5)); };
  ImagePoints<A> points;
  image.x.store_unaligned(points.x);
  image.y.store_unaligned(points.y);
  (S(1) / image.z).store_unaligned(points.inverse_depth);
  xsimd::select(inside, snapped(image.x), S(kOutside)).store_unaligned(points.snapped_x);
  const S why = xsimd::select(image.z < S(data.near), S(kBehind), S(0));
  xsimd::select(inside, snapped(image.y), why).store_unaligned(points.snapped_y);
  points.all_inside = xsimd::all(inside);
  return points;
}

template <class A>
bool transform_vertices(FrameData& data, std::size_t begin, std::size_t end) {
  constexpr std::size_t kWidth = ImagePoints<A>::kWidth;
  bool all_inside = true;
  for (std::size_t i = begin; i < end; i += kWidth) {
    const ImagePoints<A> p = image_points<A>(data, i);
    all_inside &= p.all_inside;
    for (std::size_t k = 0; k < kWidth && i + k < end; ++k) {
      VertexRecord& record = data.records[i + k];
      record.x = float(p.x[k]);
      record.y = float(p.y[k]);
      record.inverse_depth = float(p.inverse_depth[k]);
      data.points[i + k] = {std::int32_t(p.snapped_x[k]), std::int32_t(p.snapped_y[k]),
                            record.inverse_depth};
    }
  }
  return all_inside;
}

/// The lighting terms of vertices [begin, end).
template <class A>
void light_vertices(FrameData& data, const Lighting<Floats<A>>& lighting, std::size_t begin,
                    std::size_t end) {
  using S = Floats<A>;
  for (std::size_t i = begin; i < end; i += S::kWidth) {
    float position[3][S::kWidth], normal[3][S::kWidth], terms[6][S::kWidth];
    for (std::size_t k = 0; k < S::kWidth; ++k) {
      const std::size_t v = std::min(i + k, end - 1);
      position[0][k] = float(data.xs[v]);
      position[1][k] = float(data.ys[v]);
      position[2][k] = float(data.zs[v]);
      for (int c = 0; c < 3; ++c) normal[c][k] = data.records[v].normal[c];
    }
    const SurfacePoint<S> point{{S::load(position[0]), S::load(position[1]), S::load(position[2])},
                                {S::load(normal[0]), S::load(normal[1]), S::load(normal[2])}};
    const Terms<S> sum = surface_terms(point, lighting.eye_position, lighting.lights,
                                       lighting.parameters, data.shot.material);
    const Vec3<S>&d = sum.diffuse, &s = sum.specular;
    const std::array<S, 6> all{d.x, d.y, d.z, s.x, s.y, s.z};
    for (std::size_t c = 0; c < 6; ++c) all[c].store(terms[c]);
    for (std::size_t k = 0; k < S::kWidth && i + k < end; ++k) {
      for (std::size_t c = 0; c < 6; ++c) data.terms[i + k][c] = terms[c][k];
    }
  }
}

}  // namespace lumaknot::fast
