// Which samples the fast renderer covers: exactly those of the reference, given image points as it
// snaps them.
#include <gtest/gtest.h>

#include "math/angle.h"
#include "render/projection.h"
#include "tests/render/fast/testing.h"

namespace lumaknot::fast {
namespace {

using testing::Difference;
using testing::difference;
using testing::fast_image;

constexpr int kSize = 128;

/// The field of view whose tangent of a half is 1/2 to the bit, so that a pixel is 1/128 at depth
/// one.
double exact_field() {
  double degrees = 2 * std::atan(0.5) * 180 / kPi - 1e-13;
  while (std::tan(degrees * kPi / 360) < 0.5) degrees = std::nextafter(degrees, 54);
  return degrees;
}

/// The world point at image point (x, y), in 1/1024 of a pixel, and a depth of few bits: no
/// rounding on the way there and back. The camera is at z = 4.
Vec3d snapped_point(int x, int y, double depth) {
  const double half = kSize / 2.0;
  return {(x / 1024.0 - half) / kSize * depth, (half - y / 1024.0) / kSize * depth, 4 - depth};
}

Scene flat_scene() {
  Scene scene{{}, Vec3d{1, 1, 1}, {}};
  scene.view.camera = testing::axis_camera(4, exact_field());
  scene.view.image = {kSize, kSize, 1};
  scene.view.lights = {DirectionalLight{{0, 0, -1}, {}}};
  scene.view.ambient = 0.1;
  return scene;
}

/// A triangle identified by its brightness.
void add_flat(TriangleMesh& mesh, const std::array<Vec3d, 3>& corners) {
  const double tilt = 0.1 + 1.3 * double(mesh.triangles.size() % 97) / 97;
  const auto first = std::uint32_t(mesh.positions.size());
  for (const Vec3d& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back({std::sin(tilt), 0, std::cos(tilt)});
    mesh.uvs.push_back({});
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
}

void expect_identical(const Scene& scene, const Options& options) {
  ASSERT_EQ(Projection(scene.view.camera, kSize, kSize).pixel_width(), 1.0 / 128);
  const Difference d = difference(render(scene), fast_image(scene, options));
  EXPECT_EQ(d.coverage, 0);
  EXPECT_LE(d.max, 1e-4);  // floats; another triangle would differ by 0.01 or more
  EXPECT_GT(d.covered, 500);
}

/// Random triangles of at most `extent` pixels, with corners on whole and half pixels or anywhere
/// on the grid.
Scene soup(std::uint32_t seed, int count, int extent, int grid) {
  Scene scene = flat_scene();
  std::mt19937 random(seed);
  const auto below = [&](int n) { return int(random() % std::uint32_t(n)); };
  for (int i = 0; i < count; ++i) {
    const double depth = (64.0 + i) / 1024;  // each its own
    const int x = below(kSize * 1024), y = below(kSize * 1024);
    std::array<Vec3d, 3> corners;
    for (Vec3d& corner : corners) {
      const int dx = below(extent * 1024) - extent * 512, dy = below(extent * 1024) - extent * 512;
      corner = snapped_point((x + dx) / grid * grid, (y + dy) / grid * grid, depth);
    }
    add_flat(scene.mesh, corners);
  }
  return scene;
}

TEST(FastCoverage, of_small_triangles_on_snapped_points_is_the_references) {
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    expect_identical(soup(1, 3000, 8, 1), options);
    expect_identical(soup(2, 3000, 8, 512), options);  // corners and edges through samples
  }
}

// Triangles drawn several at once are not in the mesh's order.
TEST(FastCoverage, of_triangles_at_one_depth_is_the_later_ones) {
  Scene scene = soup(8, 3000, 8, 512);
  for (Vec3d& p : scene.mesh.positions) p = {p.x / (4 - p.z), p.y / (4 - p.z), 3};
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    expect_identical(scene, options);
  }
}

// The pieces of a clipped triangle keep its place in the mesh's order.
TEST(FastCoverage, of_a_clipped_triangle_at_the_depth_of_others_is_between_them) {
  Scene scene = soup(8, 3000, 8, 512);
  for (Vec3d& p : scene.mesh.positions) p = {p.x / (4 - p.z), p.y / (4 - p.z), 3};
  add_flat(scene.mesh, {Vec3d{-1e4, -1e4, 3}, {1e4, -1e4, 3}, {0, 1e4, 3}});
  auto& triangles = scene.mesh.triangles;
  std::rotate(triangles.begin() + 1500, triangles.end() - 1, triangles.end());
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    expect_identical(scene, options);
  }
}

TEST(FastCoverage, of_large_triangles_on_snapped_points_is_the_references) {
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    expect_identical(soup(3, 60, 500, 1), options);
    expect_identical(soup(4, 60, 500, 512), options);
  }
}

// The side that decides between edge functions of 32 and of 64 bits.
TEST(FastCoverage, of_triangles_about_as_large_as_small_ones_may_be_is_the_references) {
  expect_identical(soup(5, 400, 56, 1), {});
  expect_identical(soup(6, 400, 56, 512), {});
}

// Triangles that pass through each other, seen from both sides: only depth decides which is nearer.
TEST(FastCoverage, of_triangles_through_each_other_is_the_references) {
  for (const int extent : {20, 400}) {  // small, and large
    Scene scene = flat_scene();
    std::mt19937 random(7);
    const auto below = [&](int n) { return int(random() % std::uint32_t(n)); };
    for (int i = 0; i < 40; ++i) {
      const int x = below(kSize * 1024), y = below(kSize * 1024);
      std::array<Vec3d, 3> corners;
      for (Vec3d& corner : corners) {
        corner = snapped_point(x + below(extent * 1024) - extent * 512,
                               y + below(extent * 1024) - extent * 512, (64.0 + below(512)) / 128);
      }
      add_flat(scene.mesh, corners);
    }
    for (const SimdLevel level : testing::simd_levels()) {
      Options options;
      options.level = level;
      const Image reference = render(scene), fast = fast_image(scene, options);
      int differing = 0, covered = 0;
      for (std::size_t i = 0; i < fast.pixels.size(); ++i) {
        const RgbaPixel &p = reference.pixels[i], &q = fast.pixels[i];
        EXPECT_EQ(p.coverage, q.coverage);
        covered += p.coverage > 0;
        differing += std::abs(p.color.r - q.color.r) > 0.001;
      }
      EXPECT_GT(covered, 900);
      EXPECT_LE(differing, 3) << extent;  // where they cross, floats may choose the other
    }
  }
}

TEST(FastCoverage, of_a_fan_draws_every_sample_once) {
  Scene scene = flat_scene();
  // A regular fan round a pixel's centre, its rim far outside; both halves of a shared edge.
  const int middle = 64 * 1024 + 512;
  const std::array<std::array<int, 2>, 8> rim{{{200, 0},
                                               {200, 200},
                                               {0, 200},
                                               {-200, 200},
                                               {-200, 0},
                                               {-200, -200},
                                               {0, -200},
                                               {200, -200}}};
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto at = [&](std::size_t k) {
      const auto& [x, y] = rim[k % rim.size()];
      return snapped_point(middle + x * 1024, middle + y * 1024, 2);
    };
    add_flat(scene.mesh, {snapped_point(middle, middle, 2), at(i), at(i + 1)});
  }
  expect_identical(scene, {});
  for (const int samples : {2, 4, 6, 8, 16}) {
    Options options;
    options.samples = samples;
    for (const RgbaPixel& p : fast_image(scene, options).pixels) EXPECT_NEAR(p.coverage, 1, 1e-6);
  }
}

// The mean of many samples is the area: for a half plane, its edge's distance from the centre.
TEST(FastCoverage, of_samples_tells_the_covered_share) {
  for (const int samples : {1, 2, 4, 6, 8, 16}) {
    Options options;
    options.samples = samples;
    double sum = 0;
    for (int shift = 0; shift < 64; ++shift) {
      Scene scene = flat_scene();
      const int edge = 64 * 1024 + shift * 16;
      add_flat(scene.mesh, {snapped_point(edge, -1000000, 2), snapped_point(edge, 1000000, 2),
                            snapped_point(edge + 2000000, 0, 2)});
      sum += fast_image(scene, options).at(64, 64).coverage;
    }
    EXPECT_NEAR(sum / 64, 0.5, 0.5 / samples);  // the patterns are centred
  }
}

TEST(FastCoverage, of_several_samples_leaves_the_inside_as_it_is) {
  const Scene scene = testing::knot_scene(96, 400, 24);
  const Image one = fast_image(scene);
  for (const int samples : {2, 4, 6, 8, 16}) {
    Options options;
    options.samples = samples;
    const Image many = fast_image(scene, options);
    Scene fine = scene;
    fine.view.image.samples = 4;
    const Difference d = difference(render(fine), many);
    EXPECT_LT(d.mean, 0.06) << samples;  // noise of the texture; black or doubled colours are 0.3
  }
}

TEST(FastCoverage, back_faces_of_a_closed_mesh_are_not_missed) {
  const Scene scene = testing::knot_scene();
  Options options;
  options.cull_back_faces = true;
  const Difference d = difference(fast_image(scene), fast_image(scene, options));
  // Where a silhouette's front face has no sample, its back face may have one.
  EXPECT_LE(d.coverage, 30);
  EXPECT_LE(d.mean, 1e-3);
}

TEST(FastCoverage, back_faces_alone_are_not_drawn) {
  Scene scene = flat_scene();
  scene.mesh = testing::square(1);
  Options options;
  options.cull_back_faces = true;
  const auto covered = [&] {
    int count = 0;
    for (const RgbaPixel& p : fast_image(scene, options).pixels) count += p.coverage > 0;
    return count;
  };
  EXPECT_GT(covered(), 100);
  for (Triangle& t : scene.mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(covered(), 0);
}

}  // namespace
}  // namespace lumaknot::fast
