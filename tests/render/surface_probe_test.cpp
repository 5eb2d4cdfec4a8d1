#include "render/surface_probe.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lumaknot {
namespace {

/// A sheet that faces the camera at depth 4, all of it or without a gap `gap` wide that runs down
/// the image's middle; and, in the gap, a sliver as wide that lies `behind` farther away.
TriangleMesh sheet_with_sliver(double gap, double behind) {
  TriangleMesh mesh;
  const auto add = [&](double x0, double x1, double y, double normal_x) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const auto& [x, z] : {Vec2d{x0, -3}, Vec2d{x1, -3}, Vec2d{x1, 3}, Vec2d{x0, 3}}) {
      mesh.positions.push_back({x, y, z});
      mesh.normals.push_back({normal_x, -1, 0});
      mesh.uvs.push_back({0, 0});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  };
  add(-3, -gap / 2, 0, 0);
  add(gap / 2, 3, 0, 0);
  add(-gap / 2, gap / 2, behind, 1);
  return mesh;
}

const Camera kCamera{{0, -4, 0}, {0, 0, 0}, {0, 0, 1}, 45};

TEST(SurfaceProbe, sees_at_a_pixels_centre_what_the_rasterizer_draws) {
  const TriangleMesh mesh = sheet_with_sliver(0.3, 0);
  const SurfaceProbe probe(mesh, kCamera, 40, 30);
  const Rasterizer rasterizer(mesh, kCamera, 40, 30, 30);
  const Grid<Fragment> drawn = rasterizer.band(0);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const Fragment seen = probe.at(x + 0.5, y + 0.5);
      EXPECT_EQ(seen.triangle, drawn.at(x, y).triangle);
      EXPECT_EQ(seen.position, drawn.at(x, y).position);
    }
  }
}

TEST(SurfaceProbe, finds_slivers_between_the_points_of_its_grid) {
  // About 1e-4 pixels wide, a hundredth of the grid's spacing.
  const TriangleMesh mesh = sheet_with_sliver(1e-5, 0);
  const SurfaceProbe probe(mesh, kCamera, 40, 30);
  const auto is_sliver = [](const Fragment& f) { return f.covered() && f.normal.x > 0; };
  EXPECT_TRUE(std::ranges::any_of(probe.around(20.01, 15, 0.05), is_sliver));
  EXPECT_FALSE(std::ranges::any_of(probe.around(20.1, 15, 0.05), is_sliver)) << "too far away";
}

TEST(SurfaceProbe, does_not_see_what_is_hidden) {
  const TriangleMesh mesh = sheet_with_sliver(1e-9, 1);
  const SurfaceProbe probe(mesh, kCamera, 40, 30);
  for (const Fragment& seen : probe.around(10.3, 15, 0.05)) {
    ASSERT_TRUE(seen.covered());
    EXPECT_NEAR(seen.depth, 4, 1e-9);
  }
}

}  // namespace
}  // namespace lumaknot
