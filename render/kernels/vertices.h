/// The first step of a frame: vertices onto the image, and with Rate::kVertex their light.
#pragma once

#include <cmath>

#include "render/kernels/packet.h"

namespace lumaknot {

/// Doubles at a time.
template <class A>
using Doubles = xsimd::batch<double, A>;

/// Image points of Doubles::size vertices from `i` on, in the arrays x, y, depth.
template <class A>
void image_points(const FrameData& data, std::size_t i, double* x, double* y, double* depth) {
  using S = Doubles<A>;
  const Vec3<S> world{S::load_unaligned(&data.xs[i]), S::load_unaligned(&data.ys[i]),
                      S::load_unaligned(&data.zs[i])};
  const Vec3<S> image = data.projection.to_image(data.projection.to_view(world));
  image.x.store_unaligned(x);
  image.y.store_unaligned(y);
  image.z.store_unaligned(depth);
}

/// Snaps an image point and keeps it. Whether it is in front of the near plane and in the guard.
template <class A>
bool keep_point(FrameData& data, std::size_t i, double x, double y, double depth) {
  VertexRecord& record = data.records[i];
  const bool inside = depth >= data.near && x >= -kGuard && x <= kGuard && y >= -kGuard &&
                      y <= kGuard;  // false for NaN
  record.x = float(x);
  record.y = float(y);
  record.inverse_depth = float(1 / depth);
  // Rounded half up.
  data.points[i] = {inside ? std::int32_t(std::floor(x * kSubpixels + 0.5)) : kOutside,
                    inside ? std::int32_t(std::floor(y * kSubpixels + 0.5)) : 0,
                    record.inverse_depth};
  return inside;
}

template <class A>
bool transform_vertices(FrameData& data, std::size_t begin, std::size_t end) {
  constexpr std::size_t kWidth = Doubles<A>::size;
  bool all_inside = true;
  for (std::size_t i = begin; i < end; i += kWidth) {
    double x[kWidth], y[kWidth], depth[kWidth];
    image_points<A>(data, i, x, y, depth);
    for (std::size_t k = 0; k < kWidth && i + k < end; ++k) {
      all_inside &= keep_point<A>(data, i + k, x[k], y[k], depth[k]);
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
                                       lighting.model, data.shot.material);
    const Vec3<S>&d = sum.diffuse, &s = sum.specular;
    const std::array<S, 6> all{d.x, d.y, d.z, s.x, s.y, s.z};
    for (std::size_t c = 0; c < 6; ++c) all[c].store(terms[c]);
    for (std::size_t k = 0; k < S::kWidth && i + k < end; ++k) {
      for (std::size_t c = 0; c < 6; ++c) data.terms[i + k][c] = terms[c][k];
    }
  }
}

}  // namespace lumaknot
