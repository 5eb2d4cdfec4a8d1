#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <utility>

#include "math/angle.h"
#include "meshgen/spine.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

KnotSpec knot_of(int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  return knot;
}

Curve line_of(int p, int q) { return components(knot_of(p, q)).front(); }

const Curve kKnots[] = {line_of(2, 3), line_of(-2, 3), line_of(2, -3), line_of(1, 0),
                        line_of(0, 1), line_of(5, 2),  line_of(1, 1),  line_of(-7, -4)};

/// The largest distance of a derivative from the central difference, step `h`, of the one before.
double difference_error(const Curve& knot, Vec3d CurvePoint::* of, Vec3d CurvePoint::* derivative,
                        double h) {
  double worst = 0;
  for (int i = 0; i < 97; ++i) {
    const double t = 2 * kPi * i / 97;
    const Vec3d slope = (curve_point(knot, t + h).*of - curve_point(knot, t - h).*of) / (2 * h);
    worst = std::max(worst, length(slope - curve_point(knot, t).*derivative));
  }
  return worst;
}

TEST(Curve, stays_on_its_torus) {
  for (const Curve& knot : kKnots) {
    for (int i = 0; i < 97; ++i) {
      const Vec3d c = curve_point(knot, 0.07 * i).position;
      const double from_ring = std::hypot(std::hypot(c.x, c.y) - knot.major_radius, c.z);
      EXPECT_NEAR(from_ring, knot.minor_radius, 1e-14);  // rounding of lengths near one
    }
  }
}

TEST(Curve, closes_after_one_period) {
  for (const Curve& knot : kKnots) {
    const CurvePoint first = curve_point(knot, 0.3), again = curve_point(knot, 0.3 + 2 * kPi);
    // The rounding of 2 pi, seven times faster.
    EXPECT_LT(length(first.position - again.position), 1e-13);
    EXPECT_LT(length(first.first - again.first), 1e-12);
  }
}

TEST(Curve, winds_p_times_about_the_axis_and_q_times_through_the_hole) {
  for (const Curve& knot : kKnots) {
    double about = 0, through = 0;
    const int n = 1000;  // each step turns by far less than pi
    for (int i = 0; i < n; ++i) {
      const Vec3d a = curve_point(knot, 2 * kPi * i / n).position;
      const Vec3d b = curve_point(knot, 2 * kPi * (i + 1) / n).position;
      about += std::remainder(std::atan2(b.y, b.x) - std::atan2(a.y, a.x), 2 * kPi);
      const auto angle = [&](const Vec3d& c) {
        return std::atan2(c.z, std::hypot(c.x, c.y) - knot.major_radius);
      };
      through += std::remainder(angle(b) - angle(a), 2 * kPi);
    }
    EXPECT_NEAR(about / (2 * kPi), knot.p, 1e-9);  // a sum of n roundings; the result is whole
    EXPECT_NEAR(through / (2 * kPi), knot.q, 1e-9);
  }
}

TEST(Curve, derivative_never_vanishes) {
  for (const Curve& knot : kKnots) {
    for (int i = 0; i < 97; ++i) {
      EXPECT_GT(length(curve_point(knot, 0.065 * i).first), 0.3);  // w |q| or (R - w) |p|
    }
  }
}

TEST(Curve, derivatives_are_the_limits_of_central_differences_at_order_2) {
  for (const Curve& knot : kKnots) {
    for (const auto& [of, derivative] : {std::pair{&CurvePoint::position, &CurvePoint::first},
                                         {&CurvePoint::first, &CurvePoint::second},
                                         {&CurvePoint::second, &CurvePoint::third}}) {
      const double order = std::log2(difference_error(knot, of, derivative, 2e-3) /
                                     difference_error(knot, of, derivative, 1e-3));
      EXPECT_NEAR(order, 2, 0.01);  // the next term of the error is h^2 smaller
    }
  }
}

TEST(Curve, speed_is_the_length_of_the_first_derivative) {
  for (const Curve& knot : kKnots) {
    EXPECT_NEAR(speed(knot, 0.7), length(curve_point(knot, 0.7).first), 1e-13);  // rounding
  }
}

TEST(Curve, circles_have_their_curvature_and_no_torsion) {
  EXPECT_NEAR(curvature(curve_point(line_of(1, 0), 0.4)), 1 / 1.4, 1e-14);  // rounding
  EXPECT_NEAR(curvature(curve_point(line_of(0, 1), 0.4)), 1 / 0.4, 1e-14);
  EXPECT_NEAR(torsion(curve_point(line_of(1, 0), 0.4)), 0, 1e-14);
  EXPECT_NEAR(torsion(curve_point(line_of(0, 1), 0.4)), 0, 1e-14);
}

TEST(Curve, a_long_spiral_has_a_helix_s_curvature_and_torsion) {
  // On a ring so wide that its tube is straight, a (p,q) knot is a helix of radius w and pitch
  // 2 pi R p / q: curvature w / (w^2 + c^2), torsion c / (w^2 + c^2) with c = R p / q.
  KnotSpec knot = knot_of(1, 1000);
  knot.major_radius = 1000;
  knot.minor_radius = 1;
  const CurvePoint point = curve_point(components(knot).front(), 0.3);
  EXPECT_NEAR(curvature(point), 0.5, 2e-3);  // the ring bends by 1 in 1000
  EXPECT_NEAR(std::abs(torsion(point)), 0.5, 2e-3);
}

TEST(Components, are_as_many_as_the_common_divisor_and_congruent) {
  for (const auto& [p, q] : {std::pair{4, 6}, {6, 4}, {-4, 6}, {3, 3}, {5, 0}, {0, 4}, {-9, -6}}) {
    const std::vector<Curve> link = components(knot_of(p, q));
    ASSERT_EQ(link.size(), std::size_t(std::gcd(p, q)));
    for (const Curve& line : link) {
      EXPECT_EQ(line.p * int(link.size()), p);
      EXPECT_EQ(line.q * int(link.size()), q);
      if (q != 0) {
        EXPECT_NEAR(Spine(line).length(), Spine(link.front()).length(), 1e-12);  // rounding
      }
    }
  }
}

TEST(Components, do_not_meet) {
  for (const auto& [p, q] : {std::pair{4, 6}, {6, 4}, {-4, 6}, {3, 3}, {2, 0}, {0, 4}}) {
    const std::vector<Curve> link = components(knot_of(p, q));
    double nearest = 1e9;
    for (int i = 0; i < 300; ++i) {
      for (int j = 0; j < 300; ++j) {
        nearest = std::min(nearest, length(curve_point(link[0], 0.021 * i).position -
                                           curve_point(link[1], 0.021 * j).position));
      }
    }
    EXPECT_GT(nearest, 0.1) << p << "," << q;  // equally spaced on a torus of radius 0.4
  }
}

TEST(Components, that_have_no_extent_are_refused) {
  KnotSpec knot = knot_of(2, 0);
  knot.minor_radius = knot.major_radius;  // the second circle lies on the axis
  EXPECT_THAT(error_of([&] { components(knot); }), ::testing::HasSubstr("no extent"));
}

TEST(ArcLength, of_circles_is_exact) {
  for (const int sign : {1, -1}) {
    EXPECT_NEAR(Spine(line_of(sign, 0)).length(), 2 * kPi * 1.4, 1e-14);  // rounding
    EXPECT_NEAR(Spine(line_of(0, sign)).length(), 2 * kPi * 0.4, 1e-14);
  }
}

TEST(ArcLength, is_the_trapezoid_rule_s_which_is_exact_on_closed_curves) {
  for (const Curve& line : {line_of(2, 3), line_of(5, 2), line_of(3, -7), line_of(99, 1)}) {
    double sum = 0;
    const int n = 20'000;
    for (int i = 0; i < n; ++i) sum += speed(line, ring_parameter(i, n)) * 2 * kPi / n;
    EXPECT_NEAR(Spine(line).length() / sum, 1, 1e-13);  // rounding of 20,000 terms
  }
}

TEST(ArcLength, rises_by_the_speed) {
  for (const Curve& line : {line_of(2, 3), line_of(-5, 2), line_of(1, 20), line_of(1, 0)}) {
    const Spine spine(line);
    for (double t = 0.1; t < 13; t += 0.37) {  // beyond one loop too
      const double h = 1e-4;
      const double rate = (spine.arc_length(t + h) - spine.arc_length(t - h)) / (2 * h);
      EXPECT_NEAR(rate / speed(line, t), 1, 1e-5);  // (20 h)^2, and rounding of 1e-16 / h
    }
  }
}

TEST(ArcLength, is_that_of_a_fine_polygon) {
  const Curve line = line_of(2, 3);
  double polygon = 0;
  const int n = 20'000;
  for (int i = 0; i < n; ++i) {
    polygon += length(curve_point(line, ring_parameter(i + 1, n)).position -
                      curve_point(line, ring_parameter(i, n)).position);
  }
  // A chord is shorter than its arc by (curvature x arc)^2 / 24, here below 1e-7.
  EXPECT_NEAR(polygon / Spine(line).length(), 1, 1e-7);
  EXPECT_LT(polygon, Spine(line).length());
}

TEST(ArcLength, is_found_on_spindles_where_the_speed_nearly_has_a_kink) {
  KnotSpec knot = knot_of(1000, 1);
  knot.minor_radius = 2;  // the line crosses the axis, where it turns in 1/1000 of a radian
  const Curve line = components(knot).front();
  double sum = 0;
  const int n = 400'000;
  for (int i = 0; i < n; ++i) sum += speed(line, ring_parameter(i, n)) * 2 * kPi / n;
  EXPECT_NEAR(Spine(line).length() / sum, 1, 1e-12);  // rounding of 400,000 terms
}

}  // namespace
}  // namespace lumaknot
