#include "meshgen/certificate.h"

#include <gtest/gtest.h>

#include <numeric>

#include "math/angle.h"
#include "scene/presets.h"

namespace lumaknot {
namespace {

KnotSpec knot_of(int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.segments = 240;
  knot.sides = 12;
  return knot;
}

Certificate certificate_of(const KnotSpec& knot) { return certify(knot, knot_mesh(knot)); }

/// 50 knots and links: of all signs, with zeros, equal, with common divisors, in both orders.
std::vector<std::pair<int, int>> fifty() {
  std::vector<std::pair<int, int>> all{{2, 3},  {-2, 3}, {2, -3}, {-2, -3}, {1, 0}, {0, 1},
                                       {0, -2}, {3, 0},  {4, 6},  {6, 4},   {3, 3}, {-4, 2}};
  for (int p = 1; p <= 13 && all.size() < 50; ++p) {
    for (int q = p + 1; q <= 7 && all.size() < 50; ++q) {
      if (p != 2 || q != 3) all.push_back({p, q});
      all.push_back({q, p});
    }
  }
  all.resize(50);
  return all;
}

TEST(Certificate, of_fifty_knots_and_links_is_clean) {
  for (const auto& [p, q] : fifty()) {
    const Certificate c = certificate_of(knot_of(p, q));
    ASSERT_EQ(c.connected_components.size(), std::size_t(std::gcd(p, q))) << p << "," << q;
    for (const ConnectedComponent& piece : c.connected_components) {
      EXPECT_EQ(piece.euler_characteristic(), 0) << p << "," << q;
      EXPECT_EQ(piece.genus(), 1) << p << "," << q;
      EXPECT_EQ(piece.boundary_edges, 0) << p << "," << q;
    }
    EXPECT_LT(c.ring_tilt, 1e-9) << p << "," << q;      // the limit, in degrees
    EXPECT_LT(c.closing_error, 1e-9) << p << "," << q;  // the limit, in degrees
    ASSERT_TRUE(c.bound.has_value());
    EXPECT_LE(c.measured.chord, c.bound->chord) << p << "," << q;
    EXPECT_LE(c.measured.normal_degrees, c.bound->normal_degrees) << p << "," << q;
    EXPECT_GT(c.volume, 0) << p << "," << q;
    EXPECT_LT(c.volume, c.exact_volume) << p << "," << q;
  }
}

/// The share of a thin tube's volume that its mesh lacks.
double volume_error(int p, int q, int fineness) {
  KnotSpec knot = knot_of(p, q);
  knot.tube_radius = 0.05;
  knot.segments = 60 * std::max({std::abs(p), std::abs(q), 4}) / std::gcd(p, q) * fineness;
  knot.sides = 8 * fineness;
  const TriangleMesh mesh = knot_mesh(knot);
  double length = 0;
  for (const Curve& line : components(knot)) length += Spine(line).length();
  return 1 - volume(closed_mesh(knot, mesh)) / (kPi * 0.0025 * length);
}

TEST(Certificate, volume_of_fifty_knots_and_links_converges_at_order_2) {
  for (const auto& [p, q] : fifty()) {
    // The next term of the error is h^4: (pi / 8)^2 / 5 of it at the coarser grid.
    const double ratio = volume_error(p, q, 1) / volume_error(p, q, 2);
    EXPECT_NEAR(std::log2(ratio), 2, 0.05) << p << "," << q;
  }
}

TEST(Certificate, reports_three_s_tilt_and_twist) {
  KnotSpec knot = knot_defaults(Convention::kThree);
  knot.segments = 1000;
  const Certificate c = certificate_of(knot);
  EXPECT_NEAR(c.ring_tilt, 0.47, 0.005);  // known of three.js, to these digits
  EXPECT_NEAR(std::abs(c.twist), 187, 0.5);
  EXPECT_NEAR(c.stretch.along.max / c.stretch.along.min, 1.86, 0.01);
  EXPECT_FALSE(c.bound.has_value());
  EXPECT_EQ(c.connected_components.front().euler_characteristic(), 0);
}

TEST(Certificate, detects_babylon_s_seam_and_that_it_is_inside_out) {
  const Certificate c = certificate_of(knot_defaults(Convention::kBabylon));
  EXPECT_LT(c.volume, 0);
  // Its normals are averaged from faces, on 32 segments.
  EXPECT_GT(c.measured.normal_degrees, 1);
}

TEST(Certificate, stretch_is_one_along_by_arc_length) {
  const Certificate c = certificate_of(knot_of(2, 3));
  EXPECT_NEAR(c.stretch.along.min, 1, 1e-12);  // rounding of u
  EXPECT_NEAR(c.stretch.along.max, 1, 1e-12);
  EXPECT_NEAR(c.stretch.around.min, c.stretch.around.max, 1e-12);  // regular polygons
  EXPECT_LT(c.stretch.surface.min, 1);                             // inside the bend
  EXPECT_GT(c.stretch.surface.max, 1);                             // and outside it
}

TEST(Certificate, twist_cancels_the_holonomy) {
  const Certificate c = certificate_of(knot_of(2, 3));
  EXPECT_NEAR(c.twist, -c.holonomy, 1e-4);  // the double reflection that measures it: order 4
}

}  // namespace
}  // namespace lumaknot
