/// Faults of camera, mesh and knot.
#include <cmath>

#include "math/angle.h"
#include "validate/self_test/planting.h"

namespace lumaknot::validate {
namespace {

void add_camera_faults(Faults& all, const Scene& scene) {
  const Camera& camera = scene.view.camera;
  const double fov = camera.fov_degrees;
  for (const double factor : {0.5, 0.9, 1.02, 1.3}) {
    all.push_back({.what = "field of view",
                   .names = {"fov", "zoom"},
                   .numbers = {{"fov_degrees", factor * fov}},
                   .scene = of_view([factor](View& v) { v.camera.fov_degrees *= factor; })});
  }
  const Vec3d place = camera.position, target = camera.target;
  const double unit = 0.02 * length(place - target);
  const Vec3d by{unit, -0.6 * unit, 0.8 * unit};
  all.push_back({.what = "camera moved",
                 .names = {"camera-position"},
                 .numbers = {{"x", place.x + by.x}, {"y", place.y + by.y}, {"z", place.z + by.z}},
                 .scene = of_view([by](View& v) { v.camera.position = v.camera.position + by; })});
  all.push_back({.what = "camera looks elsewhere",
                 .names = {"camera-target", "shift"},
                 .numbers = {},
                 .scene = of_view([by](View& v) { v.camera.target = v.camera.target + by; })});
  for (const double degrees : {3.0, 30.0}) {
    all.push_back({.what = "camera rolled",
                   .names = {"camera-roll"},
                   .numbers = {{"degrees", degrees}},
                   .scene = of_view([degrees](View& v) {
                     const CameraFrame f = camera_frame(v.camera);
                     const double a = degrees * kDegree;
                     v.camera.up = f.up * std::cos(a) + f.right * std::sin(a);
                   })});
  }
}

void add_mesh_faults(Faults& all) {
  for (const double scale : {0.98, 1.1, 0.5}) {
    all.push_back({.what = "mesh scaled",
                   .names = {"mesh-scale"},
                   .numbers = {{"scale", scale}},
                   .scene = of_mesh([scale](TriangleMesh& mesh) {
                     for (Vec3d& p : mesh.positions) p = p * scale;
                   })});
  }
  all.push_back({.what = "mesh moved",
                 .names = {"mesh-moved"},
                 .numbers = {{"x", 0.05}, {"y", 0.02}, {"z", -0.03}},
                 .scene = of_mesh([](TriangleMesh& mesh) {
                   for (Vec3d& p : mesh.positions) p = p + Vec3d{0.05, 0.02, -0.03};
                 })});
  all.push_back({.what = "mesh rotated about z",
                 .names = {"mesh-rotated"},
                 .numbers = {{"degrees", 7}},
                 .scene = turned([](const Vec3d& v) {
                   const double c = std::cos(7 * kDegree), s = std::sin(7 * kDegree);
                   return Vec3d{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
                 })});
  all.push_back({.what = "y axis up", .names = {"mesh-y-up"}, .scene = turned([](const Vec3d& v) {
                                                                return Vec3d{v.x, -v.z, v.y};
                                                              })});
  all.push_back({.what = "y axis up, inverse",
                 .names = {"mesh-y-up-inverse"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.z, -v.y}; })});
  all.push_back({.what = "y and z exchanged",
                 .names = {"mesh-yz-exchanged"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.z, v.y}; })});
  all.push_back({.what = "mesh mirrored in x",
                 .names = {"mesh-mirrored-x"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{-v.x, v.y, v.z}; })});
  all.push_back({.what = "mesh mirrored in z",
                 .names = {"mesh-mirrored-z"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.y, -v.z}; })});
}

void add_knot_faults(Faults& all, const KnotSpec& knot) {
  all.push_back({.what = "p and q exchanged",
                 .names = {"knot-" + std::to_string(knot.q) + "-" + std::to_string(knot.p)},
                 .scene = of_knot([](KnotSpec& k) { std::swap(k.p, k.q); })});
  all.push_back({.what = "thicker tube",
                 .names = {"tube_radius"},
                 .numbers = {{"tube_radius", 1.1 * knot.tube_radius}},
                 .scene = of_knot([](KnotSpec& k) { k.tube_radius *= 1.1; })});
  all.push_back({.what = "larger minor radius",
                 .names = {"minor_radius"},
                 .numbers = {{"minor_radius", 1.05 * knot.minor_radius}},
                 .scene = of_knot([](KnotSpec& k) { k.minor_radius *= 1.05; })});
  all.push_back({.what = "a quarter of the segments and sides",
                 .names = {"grid-" + std::to_string(knot.segments / 4) + "x" +
                           std::to_string(knot.sides / 4)},
                 .scene = of_knot([](KnotSpec& k) { k.segments /= 4, k.sides /= 4; })});
}

}  // namespace

void add_placement_faults(Faults& all, const Scene& scene, const KnotSpec* knot) {
  add_camera_faults(all, scene);
  add_mesh_faults(all);
  if (knot) add_knot_faults(all, *knot);
}

}  // namespace lumaknot::validate
