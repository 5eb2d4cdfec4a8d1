#include "render/fast/clip.h"

#include <algorithm>
#include <cmath>

namespace lumaknot::fast {
namespace {

/// Distant corners leave few digits for the points where their edges meet the planes.
using Real = long double;

/// A corner of a piece: in view space, and as weights of the whole triangle's corners.
struct Corner {
  Vec3<Real> view, weights;
};

/// A half space of view space: dot(normal, v) >= min.
struct Plane {
  Vec3<Real> normal;
  Real min;
};

/// What is left of a triangle; each of the five planes may add a corner.
struct Polygon {
  std::array<Corner, 8> corners;
  std::size_t count = 0;

  void add(const Corner& corner) { corners[count++] = corner; }
  std::span<const Corner> all() const { return {corners.data(), count}; }
};

/// The point on the plane, computed in the same order for both triangles at an edge.
Corner between(const Corner& a, const Corner& b, const Plane& plane) {
  if (components(b.view) < components(a.view)) return between(b, a, plane);
  const Real from = dot(plane.normal, a.view) - plane.min;
  const Real to = dot(plane.normal, b.view) - plane.min;
  const Real t = from / (from - to);
  return {a.view + (b.view - a.view) * t, a.weights + (b.weights - a.weights) * t};
}

/// I. Sutherland and G. Hodgman, "Reentrant polygon clipping", 1974.
Polygon cut(const Polygon& polygon, const Plane& plane) {
  Polygon result;
  const auto inside = [&](const Corner& c) { return dot(plane.normal, c.view) >= plane.min; };
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Corner &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.count];
    if (inside(a)) result.add(a);
    if (inside(a) != inside(b)) result.add(between(a, b, plane));
  }
  return result;
}

/// The near plane, and those through the eye and the guard's sides.
std::array<Plane, 5> planes_of(const FrameData& data) {
  const auto side = [&](double x, double y, double sign_x, double sign_y) {
    const Vec3d ray = data.projection.ray(x, y);
    return Plane{{sign_x, sign_y, -(ray.x * sign_x + ray.y * sign_y)}, 0};
  };
  const double far = kGuard - 1;  // a pixel inside, for rounding
  return {Plane{{0, 0, 1}, data.near}, side(-far, 0, 1, 0), side(far, 0, -1, 0),
          side(0, -far, 0, -1), side(0, far, 0, 1)};
}

/// The point in whole subpixels.
SnappedPoint snapped(const Vec3<Real>& image) {
  return {std::int32_t(std::floor(image.x * kSubpixels + 0.5L)),
          std::int32_t(std::floor(image.y * kSubpixels + 0.5L)), float(1 / image.z)};
}

void append_vertex(FrameData& data, const Triangle& triangle, const Corner& corner) {
  const Vec3<Real> image = data.projection.to_image(corner.view);
  const auto mixed = [&](const auto& of) {
    const auto& [x, y, z] = corner.weights;
    return float(of(triangle[0]) * x + of(triangle[1]) * y + of(triangle[2]) * z);
  };
  VertexRecord record{float(image.x), float(image.y), float(1 / image.z), {}, {}};
  for (int c = 0; c < 3; ++c) {
    record.normal[c] = mixed([&](std::uint32_t v) { return data.records[v].normal[c]; });
  }
  for (int c = 0; c < 2; ++c) {
    record.uv[c] = mixed([&](std::uint32_t v) { return data.records[v].uv[c]; });
  }
  data.records.push_back(record);
  data.points.push_back(snapped(image));
  if (data.terms.empty()) return;
  std::array<float, 6> terms;
  for (std::size_t c = 0; c < 6; ++c) {
    terms[c] = mixed([&](std::uint32_t v) { return data.terms[v][c]; });
  }
  data.terms.push_back(terms);
}

/// Where a coordinate isn't finite, nothing is drawn.
bool is_drawable(const Polygon& polygon) {
  return std::ranges::all_of(polygon.all(), [](const Corner& c) {
    return std::isfinite(c.view.x) && std::isfinite(c.view.y) && std::isfinite(c.view.z);
  });
}

void clip_triangle(FrameData& data, std::uint32_t index, std::span<const Plane> planes) {
  const auto& [a, b, c, unused] = data.triangles[index];
  const Triangle triangle{a, b, c};
  Polygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = triangle[i];
    polygon.add({data.projection.to_view(Vec3<Real>{data.xs[v], data.ys[v], data.zs[v]}),
                 {Real(i == 0), Real(i == 1), Real(i == 2)}});
  }
  if (!is_drawable(polygon)) return;
  for (const Plane& plane : planes) polygon = cut(polygon, plane);
  if (polygon.count < 3 || !is_drawable(polygon)) return;
  const auto first = std::uint32_t(data.records.size());
  for (const Corner& corner : polygon.all()) append_vertex(data, triangle, corner);
  const auto pieces = std::uint32_t(polygon.count - 2);
  data.clipped.push_back({index, std::uint32_t(data.triangles.size()), pieces});
  for (std::uint32_t i = 0; i < pieces; ++i) {
    data.triangles.push_back({first, first + i + 1, first + i + 2, 0});
  }
}

}  // namespace

const Clipped* find_clipped(const FrameData& data, std::uint32_t first, std::uint32_t last) {
  const auto at = std::ranges::lower_bound(data.clipped, first, {}, &Clipped::triangle);
  return at == data.clipped.end() || at->triangle >= last ? nullptr : &*at;
}

void find_cut(const FrameData& data, Run& run) {
  run.cut.clear();
  for (std::uint32_t t = run.first; t < run.last; ++t) {
    bool any_outside = false, all_behind = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const SnappedPoint& point = data.points[data.triangles[t][i]];
      any_outside |= point.x == kOutside;
      all_behind &= point.x == kOutside && point.y == kBehind;
    }
    if (any_outside && !all_behind) run.cut.push_back(t);
  }
}

void clip_triangles(FrameData& data, std::span<const std::uint32_t> triangles) {
  const std::array<Plane, 5> planes = planes_of(data);
  for (const std::uint32_t t : triangles) clip_triangle(data, t, planes);
}

}  // namespace lumaknot::fast
