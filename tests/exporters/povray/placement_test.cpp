#include <gtest/gtest.h>

#include <algorithm>

#include "exporters/povray/scene.h"
#include "tests/exporters/testing.h"

namespace lumaknot::povray {
namespace {

using testing::small_scene;

/// The small scene with all lengths times `scale`, moved to `origin`, and a lamp that weakens.
Scene elsewhere(double scale, const Vec3d& origin) {
  Scene scene = small_scene(Vec3d{0.5, 0.5, 0.5});
  const auto move = [&](Vec3d& p) { p = p * scale + origin; };
  std::ranges::for_each(scene.mesh.positions, move);
  move(scene.view.camera.position);
  move(scene.view.camera.target);
  PointLight lamp;
  move(lamp.position);
  lamp.falloff = {0.5, 0.25 / scale, 0.125 / (scale * scale)};
  scene.view.lights = {lamp};
  return scene;
}

/// What the lamp's falloff leaves at the mesh's first vertex.
double weakening(const Scene& scene) {
  const auto& lamp = std::get<PointLight>(scene.view.lights.front());
  const double d = length(lamp.position - scene.mesh.positions.front());
  return lamp.falloff.constant + lamp.falloff.linear * d + lamp.falloff.quadratic * d * d;
}

/// The distance of the farthest vertex from the origin.
double reach(const TriangleMesh& mesh) {
  double most = 0;
  for (const Vec3d& p : mesh.positions) most = std::max(most, length(p));
  return most;
}

TEST(PovPlacement, leaves_common_scenes_alone) {
  for (const double scale : {0.1, 1.0, 1000.0}) {
    EXPECT_EQ(pov_placement(elsewhere(scale, {}).mesh), Placement{}) << scale;
  }
  EXPECT_EQ(pov_placement(elsewhere(1, {50, 0, 0}).mesh), Placement{});
  EXPECT_EQ(pov_placement(TriangleMesh{}), Placement{});
}

TEST(PovPlacement, brings_meshes_of_any_size_and_place_near_the_unit) {
  for (const double scale : {1e-12, 1e-6, 1e-3, 1e7, 1e12}) {
    const Scene scene = elsewhere(scale, Vec3d{1, -2, 3} * (1e4 * scale));
    const Scene near = placed(scene, pov_placement(scene.mesh));
    EXPECT_GT(reach(near.mesh), 0.5) << scale;
    EXPECT_LT(reach(near.mesh), 2) << scale;
    // 1e4 units away, a double is 2e-12 of the mesh's size.
    EXPECT_NEAR(weakening(near), weakening(scene), 1e-10) << scale;
  }
}

TEST(PovPlacement, scales_by_powers_of_two) {
  const Scene scene = elsewhere(1e-5, {});
  const Placement placement = pov_placement(scene.mesh);
  EXPECT_EQ(placement.origin, Vec3d{});
  const Scene near = placed(scene, placement);
  for (std::size_t i = 0; i < near.mesh.positions.size(); ++i) {
    EXPECT_EQ(near.mesh.positions[i], scene.mesh.positions[i] * placement.scale);
  }
  EXPECT_EQ(std::log2(placement.scale), std::round(std::log2(placement.scale)));
}

}  // namespace
}  // namespace lumaknot::povray
