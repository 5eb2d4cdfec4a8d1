#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "tests/meshgen/clearance_testing.h"

namespace lumaknot {
namespace {

using testing::clearance_of;
using testing::knot_of;

// An independent search by brute force: local minima of the distance on a grid of parameters. Pairs
// next to the diagonal have its zero as a neighbour, so they are not minima.

double distance(const Curve& a, double t_a, const Curve& b, double t_b) {
  return length(curve_point(a, t_a).position - curve_point(b, t_b).position);
}

/// The local minimum near a grid point, by a compass search that ends 1e-9 of the step from it.
double compass_search(const Curve& a, double t_a, const Curve& b, double t_b, double step) {
  double min = distance(a, t_a, b, t_b);
  for (const double end = 1e-9 * step; step > end;) {
    bool moved = false;
    for (const auto& [x, y] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
      const double near = distance(a, t_a + x * step, b, t_b + y * step);
      if (near >= min) continue;
      min = near;
      t_a += x * step;
      t_b += y * step;
      moved = true;
    }
    if (!moved) step /= 2;
  }
  return min;
}

std::vector<Vec3d> sampled(const Curve& curve, int n) {
  std::vector<Vec3d> points;
  for (int i = 0; i < n; ++i) points.push_back(curve_point(curve, ring_parameter(i, n)).position);
  return points;
}

/// The smallest of the grid's local minima that are below `limit`, refined; else `limit`. One grid
/// of n x n parameters of two components, which may be the same.
double brute_distance(const Curve& a, const Curve& b, bool same, int n, double limit) {
  const std::vector<Vec3d> as = sampled(a, n), bs = sampled(b, n);
  const auto square = [&](int i, int j) {
    const Vec3d chord = as[std::size_t((i + n) % n)] - bs[std::size_t((j + n) % n)];
    return dot(chord, chord);
  };
  // How far a minimum can be below its grid's value: half a step on both curves.
  double fastest = 0;
  for (int i = 0; i < n; ++i) fastest = std::max(fastest, speed(a, ring_parameter(i, n)));
  const double slack = 2 * kPi / n * fastest;
  double min = limit;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double here = square(i, j);
      if ((same && i == j) || std::sqrt(here) > min + slack) continue;
      bool minimum = true;
      for (const int x : {-1, 0, 1}) {
        for (const int y : {-1, 0, 1}) minimum = minimum && square(i + x, j + y) >= here;
      }
      if (!minimum) continue;
      min = std::min(min,
                     compass_search(a, ring_parameter(i, n), b, ring_parameter(j, n), 2 * kPi / n));
    }
  }
  return min;
}

double brute_radius(const KnotSpec& knot, int n) {
  const std::vector<Curve> link = components(knot);
  double sharpest = 0;
  for (int i = 0; i < 100 * n; ++i) {
    sharpest = std::max(sharpest, curvature(curve_point(link[0], ring_parameter(i, 100 * n))));
  }
  double min = 2 / sharpest;
  for (std::size_t k = 0; k < link.size(); ++k) {
    min = brute_distance(link[0], link[k], k == 0, n, min);
  }
  return min / 2;
}

TEST(ClearanceByBruteForce, agrees_on_trefoils) {
  for (const KnotSpec& knot : {knot_of(2, 3), knot_of(2, 3, 0.5), knot_of(3, 2)}) {
    const double radius = clearance_of(knot).radius;
    EXPECT_NEAR(radius, brute_radius(knot, 4000), 1e-6 * radius);  // the documented accuracy
  }
}

TEST(ClearanceByBruteForce, agrees_on_random_links) {
  std::mt19937 random(20250101);
  std::uniform_int_distribution<int> turns(-6, 6);
  std::uniform_real_distribution<double> logarithm(-3, 1);
  int bends = 0, strands = 0, crossings = 0;
  for (int i = 0; i < 200; ++i) {
    KnotSpec knot = knot_of(turns(random), turns(random), std::exp(logarithm(random)));
    if (knot.q == 0) knot.q = 1;
    const Clearance found = clearance_of(knot);
    // The brute force's curvature is sampled, which loses about 1e-6; its crossings end 1e-9 apart.
    EXPECT_NEAR(found.radius, brute_radius(knot, 160), 1e-5 * found.radius + 1e-8)
        << knot.p << " " << knot.q << " " << knot.minor_radius;
    ++(found.bends ? bends : found.radius > 0 ? strands : crossings);
  }
  EXPECT_GT(bends, 20);  // all kinds are among them
  EXPECT_GT(strands, 20);
  EXPECT_GT(crossings, 20);
}

}  // namespace
}  // namespace lumaknot
