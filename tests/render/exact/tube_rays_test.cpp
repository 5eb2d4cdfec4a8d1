#include "render/exact/tube_rays.h"

#include <gmock/gmock.h>

#include "math/angle.h"
#include "tests/render/exact/oracle.h"
#include "tests/render/testing.h"

namespace lumaknot::exact {
namespace {

using namespace testing;

KnotSpec knot_of(int p, int q, double tube) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.tube_radius = tube;
  return knot;
}

TubeRays tube_of(const KnotSpec& knot) { return {components(knot), knot.tube_radius}; }

/// From outside, through the neighbourhood of the knot.
Ray random_ray(Random& random) {
  Vec3d origin = random.point(1);
  origin = normalize(origin) * 4.0;
  return {origin, random.point(1.2) - origin};
}

/// The smallest distance of two hits' parameters, on the circle.
double min_gap(const std::vector<TubeHit>& hits) {
  double gap = 10;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double step = std::abs(hits[i].t - hits[j].t);
      if (hits[i].curve == hits[j].curve) gap = std::min({gap, step, kTurn - step});
    }
  }
  return gap;
}

/// Rays that meet the tube, all their hits found by counting changes of sign, and right to 1e-12.
void expect_all_hits_found(const KnotSpec& knot, int rays) {
  constexpr int kSteps = 6000;
  const std::vector<Curve> curves = components(knot);
  const TubeRays tube = tube_of(knot);
  Random random(7);
  int met = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = random_ray(random);
    const TubeHits found = tube.all(ray);
    ASSERT_TRUE(found.decided);
    for (const TubeHit& hit : found.hits) {
      const ExtendedHit exact = polished(curves[hit.curve], knot.tube_radius, ray, hit);
      EXPECT_LT(length(plain(exact.position) - hit.position), 1e-12);
      EXPECT_LT(length(plain(exact.normal) - hit.normal), 1e-12);
      EXPECT_NEAR(double(exact.t), hit.t, 1e-12);
      met += 1;
    }
    int changes = 0;
    for (const Curve& curve : curves) {
      changes += changes_of_sign(curve, knot.tube_radius, ray, kSteps);
    }
    // Two closer than the steps may change the sign twice unseen.
    if (min_gap(found.hits) > 2 * kTurn / kSteps) {
      EXPECT_EQ(int(found.hits.size()), changes);
    } else {
      EXPECT_GE(int(found.hits.size()), changes);
    }
  }
  EXPECT_GE(met, rays / 6);
}

TEST(TubeRays, every_hit_of_a_trefoil_is_found) { expect_all_hits_found(knot_of(2, 3, 0.18), 60); }
TEST(TubeRays, every_hit_of_a_steep_knot_is_found) {
  expect_all_hits_found(knot_of(7, -4, 0.05), 40);
}
TEST(TubeRays, every_hit_of_a_link_is_found) { expect_all_hits_found(knot_of(4, 6, 0.1), 30); }
TEST(TubeRays, every_hit_of_meridians_is_found) { expect_all_hits_found(knot_of(0, 3, 0.1), 30); }

// The tube's centre line bends at a radius of 0.19 at most: the surface has cusps and swallowtails.
TEST(TubeRays, every_hit_of_a_tube_thicker_than_its_bends_is_found) {
  KnotSpec knot = knot_of(2, 9, 0.5);
  expect_all_hits_found(knot, 40);
  knot = knot_of(0, 1, 0.6);  // a spindle
  expect_all_hits_found(knot, 40);
}

// Each point's normal plane contains the whole ray: d.C' = 0 and (C - o).C' = 0 at one t.
TEST(TubeRays, a_ray_within_a_normal_plane_meets_both_sides) {
  const TubeRays ring = tube_of(knot_of(1, 0, 0.25));  // a circle of radius 1.4
  const TubeHits across = ring.all({{3, 0, 0}, {-1, 0, 0}});
  ASSERT_TRUE(across.decided);
  ASSERT_EQ(across.hits.size(), 4u);
  const double expected[] = {3 - 1.65, 3 - 1.15, 3 + 1.15, 3 + 1.65};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(across.hits[i].distance, expected[i], 1e-14);
  EXPECT_EQ(ring.all({{1.4, 0, 2}, {0, 0, -0.5}}).hits.size(), 2u);
  EXPECT_NEAR(ring.all({{1.4, 0, 2}, {0, 0, -0.5}}).hits[0].distance, 2 * 1.75, 1e-14);
}

// Down the axis of a ring whose inner radius is 1.15 a ray at x meets it twice from 1.15 on. The
// distance of the hits is 2 sqrt(2 r e): 1.4e-7 at e = 1e-14, where rounding rules.
TEST(TubeRays, tangency_is_decided_down_to_rounding_and_owned_up_to_there) {
  const TubeRays ring = tube_of(knot_of(1, 0, 0.25));
  for (const double side : {-1.0, 1.0}) {
    for (const double e : {1e-3, 1e-6, 1e-9}) {
      const double touching = 1.4 + side * 0.25;
      const TubeHits within = ring.all({{touching - side * e, 0, 3}, {0, 0, -1}});
      EXPECT_TRUE(within.decided);
      EXPECT_EQ(within.hits.size(), 2u) << e;
      const TubeHits without = ring.all({{touching + side * e, 0, 3}, {0, 0, -1}});
      EXPECT_TRUE(without.decided);
      EXPECT_EQ(without.hits.size(), 0u) << e;
    }
    EXPECT_FALSE(ring.all({{1.4 + side * 0.25, 0, 3}, {0, 0, -1}}).decided);
  }
  // In the ring's plane, where the surface is saddle-shaped: through the hole or past it, from
  // several sides.
  for (const double angle : {0.0, 0.03, 1.0}) {
    const Vec3d out{std::cos(angle), std::sin(angle), 0}, along{-out.y, out.x, 0};
    for (const double e : {1e-3, 1e-6, 1e-9}) {
      EXPECT_EQ(ring.all({out * (1.15 + e) + along * 3.0, -along}).hits.size(), 2u);
      EXPECT_EQ(ring.all({out * (1.15 - e) + along * 3.0, -along}).hits.size(), 4u);
    }
  }
}

TEST(TubeRays, first_is_the_nearest_of_all_beyond_a_distance) {
  const TubeRays tube = tube_of(knot_of(2, 3, 0.18));
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const Ray ray = random_ray(random);
    const std::vector<TubeHit> all = tube.all(ray).hits;
    for (std::size_t k = 0; k <= all.size(); ++k) {
      const double beyond = k == 0 ? 0 : all[k - 1].distance + 1e-9;
      const FirstHit first = tube.first(ray, beyond);
      ASSERT_EQ(first.hit.has_value(), k < all.size());
      if (first.hit) {
        EXPECT_EQ(first.hit->distance, all[k].distance);
      }
    }
  }
}

TEST(TubeRays, hits_keep_with_the_size_of_the_world) {
  KnotSpec knot = knot_of(2, 3, 0.18);
  Random random(5);
  const Ray ray = random_ray(random);
  const TubeHits one = tube_of(knot).all(ray);
  ASSERT_FALSE(one.hits.empty());
  for (const double size : {0x1p-60, 0x1p60}) {  // powers of two: the same digits
    knot.major_radius = size;
    knot.minor_radius = 0.4 * size;
    knot.tube_radius = 0.18 * size;
    const TubeHits scaled = tube_of(knot).all({ray.origin * size, ray.direction});
    ASSERT_EQ(scaled.hits.size(), one.hits.size());
    for (std::size_t i = 0; i < one.hits.size(); ++i) {
      EXPECT_NEAR(scaled.hits[i].distance / size, one.hits[i].distance, 1e-14);
    }
  }
}

}  // namespace
}  // namespace lumaknot::exact
