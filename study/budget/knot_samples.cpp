#include "study/budget/knot_samples.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"

namespace lumaknot::budget {

KnotGrid::KnotGrid(const KnotSpec& knot, const TriangleMesh& mesh)
    : knot_(knot), mesh_(mesh), layout_(layout_of(knot)) {
  for (const Curve& curve : centre_lines(knot)) spines_.emplace_back(curve);
}

KnotSample KnotGrid::of_mesh(const Fragment& fragment) const {
  KnotSample sample{fragment};
  if (!fragment.covered()) return sample;
  const Triangle& corners = mesh_.triangles[std::size_t(fragment.triangle)];
  for (std::size_t i = 0; i < 3; ++i) {
    const long long vertex = corners[i] % layout_.vertices();
    const long long ring = vertex / layout_.columns, side = vertex % layout_.columns;
    sample.t += fragment.weights[i] * kTurn * double(ring) / layout_.segments;
    sample.theta += fragment.weights[i] * kTurn * double(side) / layout_.sides;
  }
  sample.seen.triangle = fragment.triangle / layout_.triangles();
  return sample;
}

KnotSample KnotGrid::of_tube(const exact::ExactFragment& fragment) const {
  KnotSample sample{fragment.fragment, fragment.t, fragment.theta};
  if (sample.seen.covered()) {
    sample.seen.normal =
        interpolated_normal(std::size_t(sample.seen.triangle), sample.t, sample.theta);
  }
  return sample;
}

RingFrame KnotGrid::frame_of(const KnotSample& sample) const {
  return frame_at(spines_[std::size_t(sample.seen.triangle)], knot_.frames, sample.t);
}

Vec3d KnotGrid::exact_position(const KnotSample& sample) const {
  return frame_of(sample).position + exact_normal(sample) * knot_.tube_radius;
}

Vec3d KnotGrid::exact_normal(const KnotSample& sample) const {
  const RingFrame frame = frame_of(sample);
  return frame.normal * std::cos(sample.theta) + frame.binormal * std::sin(sample.theta);
}

// knot_mesh() cuts each quad from corner (i, j) to (i + 1, j + 1).
Vec3d KnotGrid::interpolated_normal(std::size_t component, double t, double theta) const {
  const double x = t / kTurn * layout_.segments, y = theta / kTurn * layout_.sides;
  const int i = std::clamp(int(x), 0, layout_.segments - 1),
            j = std::clamp(int(y), 0, layout_.sides - 1);
  const double a = x - i, b = y - j;
  const auto normal = [&](int ring, int side) {
    return mesh_.normals[component * std::size_t(layout_.vertices()) +
                         std::size_t(ring) * std::size_t(layout_.columns) + std::size_t(side)];
  };
  const Vec3d first = normal(i, j) * (1 - std::max(a, b)),
              last = normal(i + 1, j + 1) * std::min(a, b);
  const Vec3d between = a >= b ? normal(i + 1, j) * (a - b) : normal(i, j + 1) * (b - a);
  return first + between + last;
}

}  // namespace lumaknot::budget
