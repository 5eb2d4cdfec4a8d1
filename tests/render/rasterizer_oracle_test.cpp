// The rasteriser against rays through every sample, cast at every triangle.
#include <gtest/gtest.h>

#include <limits>

#include "render/rasterizer.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

using testing::covered_samples;
using testing::Hit;
using testing::Random;

constexpr int kWidth = 48, kHeight = 36;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The rays' result for one sample.
struct Answer {
  std::int64_t triangle = -1;
  Hit hit{kInfinity, {}};
  bool is_doubtful = false;  ///< rounding may decide: an edge, the near plane or two equal depths
};

Answer cast(const TriangleMesh& mesh, const Camera& camera, int x, int y) {
  // Weights and relative depths are right to about 1e-13 for triangles of ordinary shape.
  constexpr double kDoubt = 1e-9;
  const Vec3d ray = testing::world_ray(camera, kWidth, kHeight, x + 0.5, y + 0.5);
  const double near = near_depth(camera);
  Answer answer;
  double second = kInfinity;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const auto hit = testing::intersect(camera.position, ray, mesh.positions[t[0]],
                                        mesh.positions[t[1]], mesh.positions[t[2]]);
    if (!hit || hit->margin() < -kDoubt || hit->t < near * (1 - kDoubt)) continue;
    if (hit->margin() < kDoubt || hit->t < near * (1 + kDoubt)) answer.is_doubtful = true;
    if (hit->t < answer.hit.t) {
      second = answer.hit.t;
      answer.triangle = std::int64_t(i);
      answer.hit = *hit;
    } else {
      second = std::min(second, hit->t);
    }
  }
  if (second - answer.hit.t < kDoubt * second) answer.is_doubtful = true;
  return answer;
}

void expect_interpolated(const Fragment& seen, const TriangleMesh& mesh, const Answer& answer) {
  const Triangle& t = mesh.triangles[std::size_t(answer.triangle)];
  Vec3d position, normal;
  Vec2d uv;
  double size = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double w = answer.hit.weights[i];
    position = position + mesh.positions[t[i]] * w;
    normal = normal + mesh.normals[t[i]] * w;
    uv.u += mesh.uvs[t[i]].u * w;
    uv.v += mesh.uvs[t[i]].v * w;
    size = std::max(size, length(mesh.positions[t[i]]));
  }
  // Both ways round about 1e-15 of the corners' size, more for triangles seen nearly edge on.
  const double tolerance = 1e-8 * size;
  EXPECT_NEAR(seen.depth, answer.hit.t, 1e-8 * answer.hit.t);
  EXPECT_NEAR(length(seen.position - position), 0, tolerance);
  EXPECT_NEAR(length(seen.normal - normal), 0, tolerance);
  EXPECT_NEAR(seen.uv.u, uv.u, tolerance);
  EXPECT_NEAR(seen.uv.v, uv.v, tolerance);
}

/// Compares every sample; returns how many see something.
int expect_what_the_rays_see(const TriangleMesh& mesh, const Camera& camera) {
  const Grid<Fragment> seen = testing::draw(mesh, camera, kWidth, kHeight);
  int covered = 0, doubtful = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Answer answer = cast(mesh, camera, x, y);
      const Fragment& fragment = seen.at(x, y);
      covered += fragment.covered();
      doubtful += answer.is_doubtful;
      if (answer.is_doubtful) continue;
      EXPECT_EQ(fragment.triangle, answer.triangle) << x << " " << y;
      if (fragment.triangle == answer.triangle && answer.triangle >= 0) {
        expect_interpolated(fragment, mesh, answer);
      }
    }
  }
  EXPECT_LT(doubtful, 10);  // random triangles meet samples within 1e-9 of an edge hardly ever
  return covered;
}

/// `count` triangles whose corners are around `center`, `size` apart.
TriangleMesh soup(Random& random, int count, double extent, double size) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3d center = random.point(extent);
    const Vec3d a = center + random.point(size), b = center + random.point(size);
    testing::add_triangle(mesh, a, b, center + random.point(size));
  }
  return mesh;
}

TEST(Rasterizer, sees_what_rays_see_of_triangles_in_front) {
  Random random(11);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(trial);
    EXPECT_GT(expect_what_the_rays_see(soup(random, 30, 0.8, 0.6), Camera{}), 100);
  }
}

TEST(Rasterizer, sees_what_rays_see_of_triangles_all_round_the_eye) {
  // The eye is in the middle of the soup: most triangles cross its plane or are behind it.
  const Camera camera{.position = {0, 0, 0}, .target = {0.3, 1, 0.2}, .fov_degrees = 100};
  Random random(12);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(trial);
    EXPECT_GT(expect_what_the_rays_see(soup(random, 20, 2, 3), camera), 100);
  }
}

TEST(Rasterizer, sees_what_rays_see_of_one_triangle_through_the_plane_of_the_eye) {
  Random random(13);
  const Camera camera{.position = {0, 0, 0}, .target = {0, 1, 0}, .fov_degrees = 120};
  int visible = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    TriangleMesh mesh;
    Vec3d front = random.point(3), back = random.point(3);
    front.y = std::abs(front.y) + 0.1;
    back.y = -std::abs(back.y) - 0.1;
    testing::add_triangle(mesh, front, back, random.point(3));
    visible += expect_what_the_rays_see(mesh, camera) > 0;
  }
  EXPECT_GT(visible, 20);
}

TEST(Rasterizer, draws_nothing_behind_the_eye) {
  const Camera camera{.position = {0, 0, 0}, .target = {0, 1, 0}, .fov_degrees = 170};
  TriangleMesh mesh;
  Random random(14);
  for (int i = 0; i < 100; ++i) {
    Vec3d corners[3];
    for (Vec3d& c : corners) c = random.point(5), c.y = -std::abs(c.y);
    testing::add_triangle(mesh, corners[0], corners[1], corners[2]);
  }
  EXPECT_EQ(covered_samples(testing::draw(mesh, camera, kWidth, kHeight)), 0);
}

TEST(Rasterizer, sees_what_rays_see_of_enormous_triangles) {
  Random random(15);
  int visible = 0;
  for (const double size : {1e3, 1e6, 1e9}) {
    for (int trial = 0; trial < 10; ++trial) {
      SCOPED_TRACE(::testing::Message() << size << " " << trial);
      visible += expect_what_the_rays_see(soup(random, 1, 1, size), Camera{}) > 0;
    }
  }
  EXPECT_GT(visible, 3);
}

TEST(Rasterizer, sees_what_rays_see_of_triangles_smaller_than_a_pixel) {
  Random random(16);  // a pixel is 0.1 wide there
  int covered = 0;
  for (const double size : {0.1, 0.05, 0.02}) {
    SCOPED_TRACE(size);
    covered += expect_what_the_rays_see(soup(random, 400, 1, size), Camera{});
  }
  EXPECT_GT(covered, 50);
}

TEST(Rasterizer, tiny_triangles_between_samples_draw_nothing) {
  const Camera camera;
  TriangleMesh mesh;
  for (int y = 1; y < kHeight; ++y) {
    for (int x = 1; x < kWidth; ++x) {  // on pixel corners, half a pixel from every sample
      const Vec3d p = camera.position + testing::world_ray(camera, kWidth, kHeight, x, y) * 4.0;
      testing::add_triangle(mesh, p, p + Vec3d{1e-6, 0, 0}, p + Vec3d{0, 0, 1e-6});
    }
  }
  EXPECT_EQ(covered_samples(testing::draw(mesh, camera, kWidth, kHeight)), 0);
}

TEST(Rasterizer, interpolates_perspective_correctly_over_a_floor_to_the_horizon) {
  const Camera camera{.position = {0, 0, 1}, .target = {0, 2, 0}, .fov_degrees = 60};
  TriangleMesh mesh;  // uv is a linear function of the position, so it must stay one
  testing::add_triangle(mesh, {-900, -300, 0}, {900, -300, 0}, {0, 900, 0});
  const Grid<Fragment> seen = testing::draw(mesh, camera, kWidth, kHeight);
  int covered = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Fragment& f = seen.at(x, y);
      if (!f.covered()) continue;
      ++covered;
      const Vec3d ray = testing::world_ray(camera, kWidth, kHeight, x + 0.5, y + 0.5);
      const Vec3d ground = camera.position + ray * (-camera.position.z / ray.z);
      // Corners up to 900 away, weights right to 1e-14 near the eye and 1e-12 at the horizon.
      EXPECT_NEAR(length(f.position - ground), 0, 1e-8);
      EXPECT_NEAR(f.uv.u, ground.x, 1e-8);
      EXPECT_NEAR(f.uv.v, 2 * ground.y, 1e-8);
      EXPECT_NEAR(f.depth, -camera.position.z / ray.z, 1e-8);
    }
  }
  EXPECT_GT(covered, kWidth * kHeight / 2);
}

TEST(Rasterizer, equal_vertices_interpolate_to_themselves) {
  TriangleMesh mesh = testing::square(3);
  mesh.uvs.assign(4, {0.3, 0.7});
  for (const Fragment& f : testing::draw(mesh, Camera{}, kWidth, kHeight).pixels) {
    if (!f.covered()) continue;
    EXPECT_NEAR(f.uv.u, 0.3, 1e-15);  // weights sum to one up to two roundings
    EXPECT_NEAR(f.uv.v, 0.7, 1e-15);
    EXPECT_NEAR(f.normal.z, 1, 1e-15);
  }
}

}  // namespace
}  // namespace lumaknot
