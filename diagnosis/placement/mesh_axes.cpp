/// A mesh whose axes were exchanged, turned or mirrored.
#include <cmath>

#include "diagnosis/cause.h"
#include "math/angle.h"

namespace lumaknot::diagnosis {

namespace {

using Turn = Vec3d (*)(const Vec3d&);

Hypothesis turned(std::string id, std::string sentence, Turn turn) {
  return discrete(std::move(id), Rung::kPlacement, std::move(sentence), [turn](Setup& s) {
    change_mesh(s, [turn](TriangleMesh& mesh) {
      for (Vec3d& p : mesh.positions) p = turn(p);
      for (Vec3d& n : mesh.normals) n = turn(n);
    });
  });
}

/// A rotation by any angle about the world's z.
Hypothesis spun() {
  Hypothesis h = continuous(
      "mesh-rotated", Rung::kPlacement, {"degrees", 0, 0.5, -360, 360},
      "the mesh rotated by {:.4g} degrees about z", [](Setup& s, double degrees) {
        const double c = std::cos(degrees * kDegree), n = std::sin(degrees * kDegree);
        const auto turn = [c, n](Vec3d& v) { v = {c * v.x - n * v.y, n * v.x + c * v.y, v.z}; };
        change_mesh(s, [turn](TriangleMesh& mesh) {
          for (Vec3d& p : mesh.positions) turn(p);
          for (Vec3d& v : mesh.normals) turn(v);
        });
      });
  for (int k = -29; k <= 30; ++k) h.starts.push_back({6.0 * k});
  return h;
}

}  // namespace

std::vector<Hypothesis> mesh_axes(const Situation&) {
  return {turned("mesh-y-up", "the mesh's y axis as up",
                 [](const Vec3d& v) { return Vec3d{v.x, -v.z, v.y}; }),
          turned("mesh-y-up-inverse", "the mesh turned as if its y axis had been up",
                 [](const Vec3d& v) { return Vec3d{v.x, v.z, -v.y}; }),
          turned("mesh-yz-exchanged", "the mesh's y and z exchanged (left-handed)",
                 [](const Vec3d& v) { return Vec3d{v.x, v.z, v.y}; }),
          turned("mesh-mirrored-x", "the mesh mirrored in x",
                 [](const Vec3d& v) { return Vec3d{-v.x, v.y, v.z}; }),
          turned("mesh-mirrored-y", "the mesh mirrored in y",
                 [](const Vec3d& v) { return Vec3d{v.x, -v.y, v.z}; }),
          turned("mesh-mirrored-z", "the mesh mirrored in z",
                 [](const Vec3d& v) { return Vec3d{v.x, v.y, -v.z}; }),
          spun()};
}

}  // namespace lumaknot::diagnosis
