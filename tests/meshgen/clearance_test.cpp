#include "meshgen/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "tests/meshgen/clearance_testing.h"

namespace lumaknot {
namespace {

using testing::clearance_of;
using testing::knot_of;

CurvePoint point_a(const std::vector<Curve>& link, const Clearance& c) {
  return curve_point(link[std::size_t(c.component_a)], c.t_a);
}

CurvePoint point_b(const std::vector<Curve>& link, const Clearance& c) {
  return curve_point(link[std::size_t(c.component_b)], c.t_b);
}

TEST(Clearance, a_ring_is_as_thick_as_its_radius) {
  for (const int p : {1, -1}) {
    const Clearance ring = clearance_of(knot_of(p, 0));
    EXPECT_NEAR(ring.radius, 1.4, 1e-15);  // rounding of R + w
    EXPECT_TRUE(ring.bends);
  }
}

TEST(Clearance, a_winding_is_as_thick_as_its_radius) {
  for (const int q : {1, -1}) {
    const Clearance circle = clearance_of(knot_of(0, q));
    EXPECT_NEAR(circle.radius, 0.4, 1e-15);  // rounding of one curvature
    EXPECT_TRUE(circle.bends);
  }
}

TEST(Clearance, windings_side_by_side_touch_at_the_hole) {
  for (const int q : {2, 3, 12, -12, 100}) {
    const Clearance circles = clearance_of(knot_of(0, q));
    const double strands = 0.6 * std::sin(kPi / std::abs(q));  // half a chord of the inner rim
    EXPECT_NEAR(circles.radius, std::min(0.4, strands), 1e-14) << q;  // rounding of the angle
    EXPECT_EQ(circles.bends, 0.4 < strands) << q;
  }
}

TEST(Clearance, rings_side_by_side_are_half_a_chord_of_the_winding_apart) {
  for (const int p : {2, 3, -7, 100}) {
    const Clearance rings = clearance_of(knot_of(p, 0));
    EXPECT_NEAR(rings.radius, 0.4 * std::sin(kPi / std::abs(p)), 1e-14) << p;  // rounding
    EXPECT_FALSE(rings.bends);
    EXPECT_NE(rings.component_a, rings.component_b);
  }
}

TEST(Clearance, rings_that_wind_through_the_axis_touch_across_it) {
  // At distances 1 + 1.3 cos(2 pi k / 3) from the axis: 2.3, 0.35, 0.35 at heights +-1.1258.
  EXPECT_NEAR(clearance_of(knot_of(3, 0, 1.3)).radius, 0.35, 1e-14);
  // At 3.5 and, beyond the axis, 1.5.
  const std::vector<Curve> link = components(knot_of(2, 0, 2.5));
  const Clearance across = clearance(link);
  EXPECT_NEAR(across.radius, 1, 1e-14);
  EXPECT_NEAR(length(point_a(link, across).position - point_b(link, across).position), 2, 1e-14);
}

TEST(Clearance, two_strands_that_face_each_other_on_all_meridians_are_a_winding_apart) {
  // With |p| = 2 the link meets each meridian circle in two opposite points, 2 w apart and
  // perpendicular to the chord; for the Hopf link and the trefoil of a thin ring that is the limit.
  for (const auto& [p, q] : {std::pair{2, 2}, {2, -2}, {2, 3}, {-2, 3}, {2, 1}}) {
    const Clearance found = clearance_of(knot_of(p, q, 0.3));
    EXPECT_NEAR(found.radius, 0.3, 1e-14) << p << " " << q;  // rounding
    EXPECT_FALSE(found.bends);
  }
}

TEST(Clearance, three_js_default_tube_is_just_thin_enough) {
  const double radius = clearance_of(knot_of(2, 3, 0.5)).radius;  // its tube is 0.4
  EXPECT_GT(radius, 0.4);
  EXPECT_LT(radius, 0.42);
}

TEST(Clearance, the_place_has_the_distance_and_its_chord_is_perpendicular) {
  for (const auto& [p, q] : {std::pair{3, 2}, {5, 7}, {-4, 6}, {3, 3}, {60, 31}, {7, 0}, {0, 5}}) {
    const std::vector<Curve> link = components(knot_of(p, q));
    const Clearance found = clearance(link);
    ASSERT_FALSE(found.bends);
    const CurvePoint a = point_a(link, found), b = point_b(link, found);
    const Vec3d chord = a.position - b.position;
    EXPECT_NEAR(length(chord), 2 * found.radius, 1e-12);  // rounding of angles up to 2 pi p
    // Newton's method, ended by the rounding of chords of 1e-2 and more.
    EXPECT_NEAR(dot(normalize(chord), normalize(a.first)), 0, 1e-10) << p << " " << q;
    EXPECT_NEAR(dot(normalize(chord), normalize(b.first)), 0, 1e-10) << p << " " << q;
  }
}

TEST(Clearance, where_it_bends_the_curvature_is_the_inverse) {
  for (const KnotSpec& knot : {knot_of(1, 1), knot_of(3, 1, 1), knot_of(1, 5, 0.2)}) {
    const std::vector<Curve> link = components(knot);
    const Clearance found = clearance(link);
    EXPECT_TRUE(found.bends);
    EXPECT_EQ(found.t_a, found.t_b);
    EXPECT_NEAR(curvature(point_a(link, found)) * found.radius, 1, 1e-12);  // rounding
  }
}

/// A thousand points of each centre line.
std::vector<Vec3d> centres(const std::vector<Curve>& link) {
  std::vector<Vec3d> points;
  for (const Curve& curve : link) {
    for (int i = 0; i < 1000; ++i) {
      points.push_back(curve_point(curve, ring_parameter(i, 1000)).position);
    }
  }
  return points;
}

double nearest(const std::vector<Vec3d>& centres, const Vec3d& point) {
  double min = std::numeric_limits<double>::infinity();
  for (const Vec3d& centre : centres) min = std::min(min, length(point - centre));
  return min;
}

/// The point of the tube's surface at the curve's parameter t and `angle`, 0 towards `up`.
Vec3d on_tube(const Curve& curve, double t, const Vec3d& up, double radius, double angle) {
  const CurvePoint c = curve_point(curve, t);
  const Vec3d side = normalize(cross(c.first, up)), over = normalize(cross(side, c.first));
  return c.position + (over * std::cos(angle) + side * std::sin(angle)) * radius;
}

TEST(Clearance, a_thinner_tube_has_its_surface_nowhere_nearer_to_the_centre_line) {
  for (const KnotSpec& knot : {knot_of(2, 3), knot_of(3, 2), knot_of(2, 3, 0.5), knot_of(1, 1),
                               knot_of(3, 1, 1), knot_of(2, 4), knot_of(0, 3)}) {
    const std::vector<Curve> link = components(knot);
    const std::vector<Vec3d> points = centres(link);
    const double radius = 0.999 * clearance(link).radius;
    for (int i = 0; i < 60; ++i) {
      for (int j = 0; j < 12; ++j) {
        const Vec3d up = curve_point(link[0], ring_parameter(i, 60)).second;
        const Vec3d x = on_tube(link[0], ring_parameter(i, 60), up, radius, ring_parameter(j, 12));
        // Samples are farther away than the centre line itself; the rest is rounding.
        ASSERT_GE(nearest(points, x), radius * (1 - 1e-12)) << knot.p << " " << knot.q;
      }
    }
  }
}

TEST(Clearance, a_thicker_tube_of_strands_has_its_surface_inside_itself) {
  for (const KnotSpec& knot : {knot_of(2, 3), knot_of(3, 2), knot_of(2, 3, 0.5), knot_of(2, 4)}) {
    const std::vector<Curve> link = components(knot);
    const Clearance found = clearance(link);
    ASSERT_FALSE(found.bends);
    const double radius = 1.001 * found.radius;
    const Vec3d a = point_a(link, found).position, b = point_b(link, found).position;
    const Vec3d surface = a + normalize(b - a) * radius;
    // From b it is 0.999 radii; 1000 samples miss less than 1e-4 of that.
    EXPECT_LT(nearest(centres(link), surface), 0.9991 * found.radius) << knot.p << " " << knot.q;
  }
}

TEST(Clearance, a_thicker_tube_that_bends_has_its_surface_inside_itself) {
  for (const KnotSpec& knot : {knot_of(1, 1), knot_of(3, 1, 1), knot_of(1, 5, 0.2)}) {
    const std::vector<Curve> link = components(knot);
    const Clearance found = clearance(link);
    ASSERT_TRUE(found.bends);
    const double radius = 1.001 * found.radius;
    const Curve& curve = link[std::size_t(found.component_a)];
    const Vec3d inwards = curve_point(curve, found.t_a).second;
    const Vec3d surface = on_tube(curve, found.t_a, inwards, radius, 0);
    // Beyond the centre of curvature neighbouring centres are nearer.
    double min = radius;
    for (int i = -1000; i <= 1000; ++i) {
      const Vec3d centre = curve_point(curve, found.t_a + 1e-4 * i).position;
      min = std::min(min, length(surface - centre));
    }
    EXPECT_LT(min, radius * (1 - 1e-9)) << knot.p << " " << knot.q;  // far beyond rounding
  }
}

TEST(Clearance, mirror_images_and_reversals_are_as_thick) {
  for (const auto& [p, q] : {std::pair{3, 2}, {5, 7}, {4, 6}, {1, 1}}) {
    const double exact = clearance_of(knot_of(p, q)).radius;
    for (const auto& [x, y] : {std::pair{1, -1}, {-1, 1}, {-1, -1}}) {
      EXPECT_NEAR(clearance_of(knot_of(x * p, y * q)).radius, exact, 1e-12 * exact);  // rounding
    }
  }
}

TEST(Clearance, scales_with_the_lengths) {
  for (const KnotSpec& knot : {knot_of(3, 2), knot_of(1, 1), knot_of(3, 0), knot_of(0, 3)}) {
    const double exact = clearance_of(knot).radius;
    for (const double scale : {1e-200, 1e-3, 7.0, 1e200}) {
      const KnotSpec scaled = knot_of(knot.p, knot.q, 0.4 * scale, scale);
      const double radius = clearance_of(scaled).radius;
      EXPECT_NEAR(radius / scale, exact, 1e-12 * exact);  // rounding
    }
  }
}

TEST(Clearance, does_not_depend_on_where_the_link_starts) {
  for (const auto& [p, q] : {std::pair{3, 2}, {5, -7}, {4, 6}, {1, 1}, {0, 3}}) {
    const std::vector<Curve> link = components(knot_of(p, q));
    const double exact = clearance(link).radius;
    for (const double shift : {0.7, -2.0, 40.0}) {
      std::vector<Curve> moved = link;
      for (Curve& curve : moved) {
        curve.longitude += shift;
        curve.meridian += 2 * shift;
      }
      const Clearance found = clearance(moved);
      EXPECT_NEAR(found.radius, exact, 1e-12 * exact);  // rounding
      if (found.bends) {
        EXPECT_NEAR(curvature(point_a(moved, found)) * exact, 1, 1e-12);
      } else {
        EXPECT_NEAR(length(point_a(moved, found).position - point_b(moved, found).position),
                    2 * exact, 1e-12);
      }
    }
  }
}

TEST(Clearance, is_the_same_whichever_component_comes_first) {
  std::vector<Curve> link = components(knot_of(6, 9));
  const double exact = clearance(link).radius;
  for (int i = 0; i < 3; ++i) {
    std::rotate(link.begin(), link.begin() + 1, link.end());
    EXPECT_NEAR(clearance(link).radius, exact, 1e-12 * exact);  // rounding
  }
}

TEST(Clearance, is_zero_where_strands_cross_on_the_axis) {
  // With w >= R each turn passes through the same one or two points of the axis.
  for (const double winding : {1.0, 1.2, 3.0}) {
    for (const auto& [p, q] : {std::pair{2, 3}, {1, 2}, {0, 2}, {3, 3}, {1000, 999}, {1, 1000}}) {
      const std::vector<Curve> link = components(knot_of(p, q, winding));
      const Clearance found = clearance(link);
      EXPECT_EQ(found.radius, 0) << p << " " << q << " " << winding;
      EXPECT_FALSE(found.bends);
      EXPECT_LT(length(point_a(link, found).position - point_b(link, found).position), 1e-11);
    }
  }
}

TEST(Clearance, of_many_turns_is_half_the_distance_of_neighbours) {
  // Neighbours cross a meridian circle 2 pi w / |p| apart, a parallel circle 2 pi r / |q| apart; on
  // a surface that is flat over such lengths they are parallel lines.
  for (const auto& [p, q] : {std::pair{1000, 999}, {1000, 1}, {500, 500}, {999, -1000}}) {
    const double inner = 0.6;
    const double across = std::hypot(p * inner, q * 0.4);
    const double spacing = 2 * kPi * 0.4 * inner / across;
    // The surface bends by the square of the spacing; along the inner rim the spacing is smallest
    // except for p >> q, where it is nearly the same everywhere.
    EXPECT_NEAR(clearance_of(knot_of(p, q)).radius, spacing / 2, 1e-5 * spacing) << p << " " << q;
  }
}

TEST(Clearance, of_steep_links_near_the_axis_is_found) {
  // Their speed and curvature change a hundred times within a hundredth of the meridian.
  for (const auto& [p, winding] : {std::pair{286, 0.999}, {300, 2.0}, {1000, 1.0}, {1000, 1.01}}) {
    const std::vector<Curve> link = components(knot_of(p, 1, winding));
    const Clearance found = clearance(link);
    const double radius =
        found.bends ? 1 / curvature(point_a(link, found))
                    : length(point_a(link, found).position - point_b(link, found).position) / 2;
    EXPECT_GT(radius, 0);
    EXPECT_NEAR(found.radius, radius, 1e-9 * radius);  // rounding of angles up to 2 pi p
  }
}

}  // namespace
}  // namespace lumaknot
