// Which triangle owns a sample on an edge: none is lost, none is drawn twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "math/angle.h"
#include "render/rasterizer.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

using testing::covered_samples;
using testing::Random;

constexpr int kSize = 16;

/// The point at `depth` that is seen at the image point (x, y) of kSize x kSize pixels.
Vec3d seen_at(const Camera& camera, double x, double y, double depth) {
  return camera.position + testing::world_ray(camera, kSize, kSize, x, y) * depth;
}

/// Draws each triangle alone and expects each sample in exactly one.
void expect_a_partition(const TriangleMesh& mesh, const Camera& camera) {
  const std::vector<int> counts = testing::times_drawn(mesh, camera, kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x)
      ASSERT_EQ(counts[std::size_t(y * kSize + x)], 1) << x << " " << y;
  }
}

Triangle turned(const Triangle& t, int way) {
  const auto k = std::size_t(way % 3);
  const Triangle rotated{t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  return way < 3 ? rotated : Triangle{rotated[0], rotated[2], rotated[1]};
}

/// Two triangles over the whole image whose common edge runs through sample centres along (dx, dy).
TriangleMesh halves(const Camera& camera, int dx, int dy, double depth_slope) {
  constexpr double kCenter = 8.5, kFar = 60;  // far outside the image, still through centres
  TriangleMesh mesh;
  const auto add = [&](double x, double y) {
    // A depth whose inverse is linear in the image keeps the four corners in one plane.
    const double depth = 4 / (1 + depth_slope * (x + y - 2 * kCenter) / 1000);
    return testing::add_vertex(mesh, seen_at(camera, kCenter + x, kCenter + y, depth));
  };
  const std::uint32_t a = add(-kFar * dx, -kFar * dy), b = add(kFar * dx, kFar * dy);
  const std::uint32_t c = add(-kFar * dy, kFar * dx), d = add(kFar * dy, -kFar * dx);
  mesh.triangles = {{a, b, c}, {b, a, d}};
  return mesh;
}

TEST(Rasterizer, shared_edges_draw_every_sample_exactly_once) {
  for (const Camera& camera : {testing::axis_camera(), Camera{}}) {
    for (int dx = -4; dx <= 4; ++dx) {
      for (int dy = 0; dy <= 4; ++dy) {
        if (std::gcd(dx, dy) != 1) continue;
        SCOPED_TRACE(::testing::Message() << "edge along " << dx << " " << dy);
        for (const double slope : {0.0, 0.5})
          expect_a_partition(halves(camera, dx, dy, slope), camera);
      }
    }
  }
}

TEST(Rasterizer, shared_edges_draw_every_sample_once_whatever_the_winding_and_first_corner) {
  const Camera camera = testing::axis_camera();
  for (const auto& [dx, dy] : {std::array{1, 0}, {0, 1}, {1, 1}, {1, -1}, {3, 1}, {-2, 3}}) {
    const TriangleMesh mesh = halves(camera, dx, dy, 0);
    for (int first = 0; first < 6; ++first) {
      for (int second = 0; second < 6; ++second) {
        SCOPED_TRACE(::testing::Message() << dx << " " << dy << ": " << first << " " << second);
        TriangleMesh wound = mesh;
        wound.triangles = {turned(mesh.triangles[0], first), turned(mesh.triangles[1], second)};
        expect_a_partition(wound, camera);
      }
    }
  }
}

TEST(Rasterizer, fans_about_any_point_of_the_image_draw_every_sample_exactly_once) {
  const Camera camera;
  Random random(5);
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    TriangleMesh mesh;
    testing::add_vertex(mesh, seen_at(camera, random.between(0, kSize), random.between(0, kSize),
                                      random.between(1, 9)));
    const int spokes = 3 + trial % 12;
    const double start = random.between(0, 6);
    for (int i = 0; i < spokes; ++i) {  // three spokes at this radius still surround the image
      const double angle = start + kTurn * i / spokes;
      testing::add_vertex(mesh, seen_at(camera, kSize / 2.0 + 100 * std::cos(angle),
                                        kSize / 2.0 + 100 * std::sin(angle), random.between(1, 9)));
    }
    for (std::uint32_t i = 0; i < std::uint32_t(spokes); ++i) {
      mesh.triangles.push_back(turned({0, i + 1, (i + 1) % std::uint32_t(spokes) + 1}, trial % 6));
    }
    expect_a_partition(mesh, camera);
  }
}

/// A grid of cells x cells quads over more than the image, its inner vertices where `place` says.
template <class Place>
TriangleMesh grid(const Camera& camera, int cells, Place place) {
  TriangleMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const Vec3d p = place(i, j);
      testing::add_vertex(mesh, seen_at(camera, p.x, p.y, p.z));
    }
  }
  const auto at = [&](int i, int j) { return std::uint32_t(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back(turned({at(i, j), at(i + 1, j + 1), at(i, j + 1)}, (i + j) % 6));
    }
  }
  return mesh;
}

TEST(Rasterizer, jittered_meshes_over_the_image_draw_every_sample_exactly_once) {
  const Camera camera;
  Random random(6);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(trial);
    const int cells = 4 + trial;
    const double cell = (kSize + 8.0) / cells;
    expect_a_partition(grid(camera, cells,
                            [&](int i, int j) {  // a jitter below half a cell folds nothing over
                              const double x = cell * (i + random.between(-0.3, 0.3)) - 4;
                              const double y = cell * (j + random.between(-0.3, 0.3)) - 4;
                              return Vec3d{x, y, random.between(2, 6)};
                            }),
                       camera);
  }
}

TEST(Rasterizer, meshes_with_vertices_on_sample_centres_draw_every_sample_exactly_once) {
  for (const double fov : {90.0, 45.0}) {
    const Camera camera = testing::axis_camera(4, fov);
    for (const double depth : {1.0, 4.0, 5.3}) {
      SCOPED_TRACE(::testing::Message() << fov << " degrees, depth " << depth);
      expect_a_partition(grid(camera, 10,
                              [&](int i, int j) {  // every second centre, and beyond the image
                                return Vec3d{2 * i - 1.5, 2 * j - 1.5, depth};
                              }),
                         camera);
    }
  }
}

/// Whether the sample (8, 8) of the axis camera is drawn by a triangle whose given edge runs
/// through it exactly: coordinates are powers of two times the sample's, so that no rounding
/// decides.
bool draws_center(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  TriangleMesh mesh;
  testing::add_triangle(mesh, a, b, c);
  return testing::draw(mesh, testing::axis_camera(), kSize, kSize).at(8, 8).covered();
}

TEST(Rasterizer, sample_on_an_edge_belongs_to_the_triangle_right_of_it_or_below_it) {
  const Vec3d ray = Projection(testing::axis_camera(), kSize, kSize).ray(8.5, 8.5);
  const double x = 4 * ray.x, y = 4 * ray.y;  // in the plane z = 0, at depth 4
  EXPECT_TRUE(draws_center({x, -4, 0}, {x + 2, 0, 0}, {x, 4, 0})) << "left edge";
  EXPECT_FALSE(draws_center({x, -4, 0}, {x, 4, 0}, {x - 2, 0, 0})) << "right edge";
  EXPECT_TRUE(draws_center({-4, y, 0}, {4, y, 0}, {0, y - 2, 0})) << "top edge";
  EXPECT_FALSE(draws_center({-4, y, 0}, {4, y, 0}, {0, y + 2, 0})) << "bottom edge";
}

TEST(Rasterizer, both_windings_of_a_triangle_draw_the_same_samples) {
  const Camera camera;
  Random random(7);
  for (int trial = 0; trial < 30; ++trial) {
    TriangleMesh mesh;
    testing::add_triangle(mesh, random.point(1.5), random.point(1.5), random.point(1.5));
    const int front = covered_samples(testing::draw(mesh, camera, 40, 40));
    std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
    EXPECT_EQ(covered_samples(testing::draw(mesh, camera, 40, 40)), front);
    EXPECT_GT(front, 0);
  }
}

}  // namespace
}  // namespace lumaknot
