#include "meshgen/tangents.h"

#include <algorithm>

namespace lumaknot {
namespace {

/// The component of `v` normal to the unit vector `normal`, unit; zero when they are parallel.
Vec3d across(const Vec3d& v, const Vec3d& normal) {
  const Vec3d flat = v - normal * dot(normal, v);
  const double size = length(flat);
  return size > 0 ? flat / size : Vec3d{};
}

/// A triangle's direction of increasing u, of any length, and the sign of its area in the texture.
struct Mapping {
  Vec3d direction;
  double sign;
};

Mapping mapping_of(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3d a = mesh.positions[t[1]] - mesh.positions[t[0]];
  const Vec3d b = mesh.positions[t[2]] - mesh.positions[t[0]];
  const Vec2d &o = mesh.uvs[t[0]], &x = mesh.uvs[t[1]], &y = mesh.uvs[t[2]];
  const double area = (x.u - o.u) * (y.v - o.v) - (x.v - o.v) * (y.u - o.u);
  const double sign = area < 0 ? -1 : 1;
  return {(a * (y.v - o.v) - b * (x.v - o.v)) * sign, area == 0 ? 0 : sign};
}

/// The angle at corner `c` of a triangle, seen along `normal`.
double angle_at(const TriangleMesh& mesh, const Triangle& t, std::size_t c, const Vec3d& normal) {
  const Vec3d& here = mesh.positions[t[c]];
  const Vec3d next = across(mesh.positions[t[(c + 1) % 3]] - here, normal);
  const Vec3d last = across(mesh.positions[t[(c + 2) % 3]] - here, normal);
  return std::acos(std::clamp(dot(next, last), -1.0, 1.0));
}

Vec3d some_direction_across(const Vec3d& normal) {
  return across(std::abs(normal.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal);
}

}  // namespace

Bulk<Tangent> tangents(const TriangleMesh& mesh) {
  Bulk<Tangent> result(mesh.positions.size(), Tangent{{}, 0});
  for (const Triangle& t : mesh.triangles) {
    const Mapping mapping = mapping_of(mesh, t);
    if (mapping.sign == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d& normal = mesh.normals[t[c]];
      Tangent& sum = result[t[c]];
      const Vec3d along = across(mapping.direction, normal);
      sum.direction = sum.direction + along * angle_at(mesh, t, c, normal);
      if (sum.sign == 0) sum.sign = mapping.sign;
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    Tangent& tangent = result[i];
    const double size = length(tangent.direction);
    tangent.direction =
        size > 0 ? tangent.direction / size : some_direction_across(mesh.normals[i]);
    if (tangent.sign == 0) tangent.sign = 1;
  }
  return result;
}

}  // namespace lumaknot
