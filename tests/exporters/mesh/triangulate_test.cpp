#include "exporters/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "math/angle.h"

namespace lumaknot {
namespace {

/// The area along `normal` of each triangle and their sum.
double area_of_cut(const std::vector<Vec3d>& polygon, const Vec3d& normal) {
  const auto triangles = triangulate(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3d area = cross(polygon[b] - polygon[a], polygon[c] - polygon[a]) / 2.0;
    EXPECT_GE(dot(area, normal), -1e-12);  // roundings of an area about 1
    sum += length(area);
  }
  return sum;
}

/// The shoelace formula in the plane z = 0.
double shoelace(const std::vector<Vec3d>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

/// A star about the origin with random radii: never crosses itself.
std::vector<Vec3d> star(int corners, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.1, 1);
  std::vector<Vec3d> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = kTurn * i / corners, r = radius(random);
    polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return polygon;
}

TEST(Triangulate, convex_polygons_are_cut_from_their_first_corner) {
  const std::vector<Vec3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> fan{{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(triangulate(square), fan);
}

TEST(Triangulate, concave_polygons_keep_their_area) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::vector<Vec3d> polygon = star(4 + int(seed) % 60, seed);
    // Sums of 60 areas below 1 in double.
    EXPECT_NEAR(area_of_cut(polygon, {0, 0, 1}), shoelace(polygon), 1e-12) << seed;
  }
}

TEST(Triangulate, concave_polygons_keep_their_area_in_any_plane_and_size) {
  const Vec3d u = normalize(Vec3d{1, 2, 3}), v = normalize(cross(u, {0, 0, 1}));
  for (const double size : {1e-30, 1.0, 1e30}) {
    std::vector<Vec3d> polygon = star(30, 7);
    const double area = shoelace(polygon) * size * size;
    for (Vec3d& p : polygon) p = size * (p.x * u + p.y * v + Vec3d{5, 6, 7});
    double sum = 0;
    for (const auto& [a, b, c] : triangulate(polygon)) {
      sum += length(cross(polygon[b] - polygon[a], polygon[c] - polygon[a])) / 2;
    }
    EXPECT_NEAR(sum / area, 1, 1e-12) << size;  // roundings of lengths about 10
  }
}

TEST(Triangulate, a_spiral_keeps_its_area) {
  std::vector<Vec3d> polygon;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 0.1 * i;
    polygon.push_back({(1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle), 0});
  }
  for (int i = 200; i >= 0; --i) {
    const double angle = 0.1 * i;
    polygon.push_back({(0.5 + angle) * std::cos(angle), (0.5 + angle) * std::sin(angle), 0});
  }
  ASSERT_GT(shoelace(polygon), 0);
  // Areas up to 100 in double.
  EXPECT_NEAR(area_of_cut(polygon, {0, 0, 1}), shoelace(polygon), 1e-10);
}

TEST(Triangulate, corners_on_a_straight_edge_cost_no_area) {
  const std::vector<Vec3d> polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                   {2, 2, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}};
  EXPECT_NEAR(area_of_cut(polygon, {0, 0, 1}), shoelace(polygon), 1e-12);
}

TEST(Triangulate, a_hole_joined_by_a_bridge_keeps_the_area_around_it) {
  const std::vector<Vec3d> polygon{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                   {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_NEAR(area_of_cut(polygon, {0, 0, 1}), 12, 1e-12);
}

TEST(Triangulate, polygons_that_cross_themselves_or_have_no_area_still_give_triangles) {
  const std::vector<Vec3d> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(bow).size(), 2u);
  EXPECT_EQ(triangulate(std::vector<Vec3d>(5, Vec3d{1, 2, 3})).size(), 3u);
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2u);
}

}  // namespace
}  // namespace lumaknot
