// What decides between triangles, what is never drawn, and what must not matter.
#include <gtest/gtest.h>

#include <limits>

#include "render/rasterizer.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

using testing::covered_samples;
using testing::draw;
using testing::Random;
using testing::same;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = std::uint32_t(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  a.uvs.insert(a.uvs.end(), b.uvs.begin(), b.uvs.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

TriangleMesh soup(std::uint32_t seed) {
  Random random(seed);
  TriangleMesh mesh;
  for (int i = 0; i < 60; ++i) {
    const Vec3d a = random.point(2), b = random.point(2);
    testing::add_triangle(mesh, a, b, random.point(2));
  }
  return mesh;
}

TEST(Rasterizer, the_nearest_triangle_is_seen_whatever_the_order) {
  const TriangleMesh near = testing::square(9, 1), far = testing::square(9, 0);
  const Camera camera = testing::axis_camera();
  for (const Fragment& f : draw(joined(near, far), camera, 8, 8).pixels) EXPECT_LT(f.triangle, 2);
  for (const Fragment& f : draw(joined(far, near), camera, 8, 8).pixels) EXPECT_GE(f.triangle, 2);
}

TEST(Rasterizer, of_equal_depths_the_later_triangle_is_seen) {
  TriangleMesh mesh;
  for (int i = 0; i < 3; ++i) testing::add_triangle(mesh, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0});
  int covered = 0;
  for (const Fragment& f : draw(mesh, testing::axis_camera(), 8, 8).pixels) {
    if (!f.covered()) continue;
    ++covered;
    EXPECT_EQ(f.triangle, 2);
  }
  EXPECT_GT(covered, 0);
}

TEST(Rasterizer, nothing_nearer_than_the_near_depth_is_drawn) {
  const Camera camera{.position = {0, 0, 0}, .target = {0, 2, 0}, .fov_degrees = 120};
  const double near = near_depth(camera);
  int covered = 0;
  for (const double tilt : {0.2, 1.0, 5.0}) {  // planes through the eye's neighbourhood
    TriangleMesh mesh;
    testing::add_triangle(mesh, {-3, -0.5, -1e-3}, {3, -0.5, -1e-3 * tilt}, {0.1, 4, -1e-3});
    for (const Fragment& f : draw(mesh, camera, 64, 64).pixels) {
      if (!f.covered()) continue;
      ++covered;
      EXPECT_GE(f.depth, near);
    }
  }
  EXPECT_GT(covered, 100);
}

TEST(Rasterizer, near_depth_divides_what_is_drawn_from_what_is_not) {
  const Camera camera = testing::axis_camera(4);
  const double near = near_depth(camera);
  EXPECT_EQ(near, 4e-3);
  EXPECT_EQ(covered_samples(draw(testing::square(1, 4 - 0.999 * near), camera, 8, 8)), 0);
  EXPECT_EQ(covered_samples(draw(testing::square(1, 4 - 1.001 * near), camera, 8, 8)), 64);
}

TEST(Rasterizer, a_triangle_too_near_hides_nothing) {
  const Camera camera = testing::axis_camera(4);
  const TriangleMesh mesh = joined(testing::square(9, 0), testing::square(1, 4 - 1e-3));
  for (const Fragment& f : draw(mesh, camera, 8, 8).pixels) {
    EXPECT_TRUE(f.covered());
    EXPECT_LT(f.triangle, 2);
  }
}

TEST(Rasterizer, degenerate_triangles_draw_nothing) {
  const Camera camera = testing::axis_camera();
  TriangleMesh mesh;
  testing::add_triangle(mesh, {1, 1, 0}, {1, 1, 0}, {1, 1, 0});    // a point
  testing::add_triangle(mesh, {-9, 0, 0}, {9, 0, 0}, {-9, 0, 0});  // an edge there and back
  testing::add_triangle(mesh, {-8, -8, 0}, {0, 0, 0}, {8, 8, 0});  // on a line, through samples
  testing::add_triangle(mesh, {0, 0, 4}, {0, 0, 4}, {1, 0, 0});    // in the eye
  testing::add_triangle(mesh, {0, -9, 1}, {0, 9, 1}, {0, 0, -9});  // edge on
  mesh.triangles.push_back({0, 0, 4});                             // one index twice
  for (const int size : {8, 9}) {  // samples beside the axes, and on them
    EXPECT_EQ(covered_samples(draw(mesh, camera, size, size)), 0) << size;
  }
}

TEST(Rasterizer, triangles_with_numbers_that_are_not_finite_draw_nothing) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 9; ++i) {
      for (const Camera& camera : {testing::axis_camera(), Camera{}}) {
        TriangleMesh mesh = testing::square(9);
        mesh.triangles.resize(1);
        Vec3d& p = mesh.positions[std::size_t(i / 3)];
        (i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z) = bad;
        EXPECT_EQ(covered_samples(draw(mesh, camera, 16, 16)), 0) << bad << " in component " << i;
      }
    }
  }
}

TEST(Rasterizer, bad_triangles_leave_their_neighbours_alone) {
  const TriangleMesh good = soup(21);
  TriangleMesh bad;
  testing::add_triangle(bad, {kNan, 0, 0}, {1, 0, 0}, {0, 1, 0});
  testing::add_triangle(bad, {0, 0, 0}, {1, kInfinity, 0}, {0, 1, 0});
  testing::add_triangle(bad, {1e200, 0, 0}, {-1e200, 1e200, 0}, {0, -1e200, 1e200});
  const Grid<Fragment> alone = draw(good, Camera{}, 32, 24);
  const Grid<Fragment> together = draw(joined(good, bad), Camera{}, 32, 24);
  for (std::size_t i = 0; i < alone.pixels.size(); ++i) {
    EXPECT_TRUE(same(alone.pixels[i], together.pixels[i])) << i;
  }
}

TEST(Rasterizer, an_empty_mesh_draws_nothing) {
  EXPECT_EQ(covered_samples(draw(TriangleMesh{}, Camera{}, 7, 5)), 0);
}

TEST(Rasterizer, bands_of_any_height_give_the_same_picture) {
  const TriangleMesh mesh = soup(22);
  const Grid<Fragment> whole = draw(mesh, Camera{}, 40, 37, 37);
  for (const int height : {1, 2, 3, 7, 16, 36, 38, 1000}) {
    const Grid<Fragment> banded = draw(mesh, Camera{}, 40, 37, height);
    ASSERT_EQ(banded.height, 37);
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
      ASSERT_TRUE(same(banded.pixels[i], whole.pixels[i])) << height << " at " << i;
    }
  }
}

TEST(Rasterizer, last_band_holds_the_rows_that_are_left) {
  const TriangleMesh mesh = testing::square(1);
  const Rasterizer rasterizer(mesh, Camera{}, 5, 10, 4);
  ASSERT_EQ(rasterizer.bands(), 3);
  EXPECT_EQ(rasterizer.band(0).height, 4);
  EXPECT_EQ(rasterizer.band(2).height, 2);
  EXPECT_EQ(rasterizer.band(2).width, 5);
}

TEST(Rasterizer, a_background_filling_square_fills_images_of_any_size) {
  const Camera camera = testing::axis_camera();
  for (const auto& [width, height] :
       {std::array{1, 1}, {1, 31}, {31, 1}, {2, 3}, {64, 17}, {17, 64}}) {
    const Grid<Fragment> seen = draw(testing::square(1000), camera, width, height);
    EXPECT_EQ(covered_samples(seen), width * height) << width << " x " << height;
  }
}

TEST(Rasterizer, one_pixel_looks_at_the_target) {
  const Camera camera{.position = {1, 2, 4}, .target = {0.2, 0.1, 0}, .up = {0, 1, 0}};
  const Grid<Fragment> seen = draw(testing::square(5), camera, 1, 1);
  ASSERT_TRUE(seen.at(0, 0).covered());
  // A few roundings of numbers below 10.
  EXPECT_NEAR(length(seen.at(0, 0).position - camera.target), 0, 1e-13);
}

TEST(Rasterizer, samples_of_an_odd_multiple_size_include_those_of_the_image) {
  const TriangleMesh mesh = soup(23);
  const Grid<Fragment> small = draw(mesh, Camera{}, 20, 15), large = draw(mesh, Camera{}, 60, 45);
  int covered = 0;
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) {
      const Fragment &a = small.at(x, y), &b = large.at(3 * x + 1, 3 * y + 1);
      EXPECT_EQ(a.triangle, b.triangle);
      EXPECT_NEAR(a.depth, b.depth, 1e-9);  // rounding, more where a triangle is nearly edge on
      covered += a.covered();
    }
  }
  EXPECT_GT(covered, 100);
}

TEST(Rasterizer, uncovered_samples_hold_zeros) {
  for (const Fragment& f : draw(TriangleMesh{}, Camera{}, 3, 3).pixels) {
    EXPECT_TRUE(same(f, Fragment{}));
  }
}

}  // namespace
}  // namespace lumaknot
