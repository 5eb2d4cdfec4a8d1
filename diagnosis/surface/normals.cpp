/// Other normals than the mesh has.
#include <map>

#include "diagnosis/cause.h"
#include "render/triangle.h"

namespace lumaknot::diagnosis {

namespace {

/// Normals averaged from the triangles around each position, weighted by area.
void smooth(TriangleMesh& mesh) {
  const auto key = [](const Vec3d& p) { return std::array{p.x, p.y, p.z}; };
  std::map<std::array<double, 3>, Vec3d> sums;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d area = area_vector(mesh, t);
    for (const std::uint32_t v : t) {
      Vec3d& sum = sums[key(mesh.positions[v])];
      sum = sum + area;
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3d& sum = sums[key(mesh.positions[v])];
    if (length(sum) > 0) mesh.normals[v] = normalize(sum);
  }
}

}  // namespace

std::vector<Hypothesis> normals(const Situation& situation) {
  std::vector<Hypothesis> all{
      discrete("normals-flat", Rung::kSurface, "flat triangles",
               [](Setup& s) { s.normals.flat = true; }),
      discrete("normals-inverted", Rung::kSurface, "normals that point inwards",
               [](Setup& s) { s.normals.inverted = true; }),
      discrete("normals-turned", Rung::kSurface, "normals turned to the viewer",
               [](Setup& s) { s.normals.turned = true; }),
      discrete("normals-averaged", Rung::kSurface, "normals averaged from the triangles",
               [](Setup& s) { change_mesh(s, smooth); })};
  if (situation.setup.view.material.normal == lumaknot::NormalUse::kUnit) {
    all.push_back(discrete(
        "normals-not-unit", Rung::kSurface, "interpolated normals that are not renormalised",
        [](Setup& s) { s.view.material.normal = lumaknot::NormalUse::kInterpolated; }));
  } else {
    all.push_back(discrete("normals-unit", Rung::kSurface, "normals renormalised per pixel",
                           [](Setup& s) { s.view.material.normal = lumaknot::NormalUse::kUnit; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
