#include "meshgen/curve.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace lumaknot {
namespace {

constexpr double kPi = std::numbers::pi;

KnotSpec knot_of(int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  return knot;
}

const KnotSpec kKnots[] = {knot_of(2, 3), knot_of(-2, 3), knot_of(2, -3), knot_of(1, 0),
                           knot_of(0, 1), knot_of(5, 2),  knot_of(1, 1),  knot_of(-7, -4)};

/// The largest distance of the derivative from a central difference with step `h`.
double difference_error(const KnotSpec& knot, double h) {
  double worst = 0;
  for (int i = 0; i < 97; ++i) {
    const double t = 2 * kPi * i / 97;
    const Vec3d slope =
        (curve_point(knot, t + h).position - curve_point(knot, t - h).position) / (2 * h);
    worst = std::max(worst, length(slope - curve_point(knot, t).derivative));
  }
  return worst;
}

TEST(Curve, stays_on_its_torus) {
  for (const KnotSpec& knot : kKnots) {
    for (int i = 0; i < 97; ++i) {
      const Vec3d c = curve_point(knot, 0.07 * i).position;
      const double from_ring = std::hypot(std::hypot(c.x, c.y) - knot.ring_radius, c.z);
      EXPECT_NEAR(from_ring, knot.winding_radius, 1e-14);  // rounding of lengths near one
    }
  }
}

TEST(Curve, closes_after_one_period) {
  for (const KnotSpec& knot : kKnots) {
    const CurvePoint first = curve_point(knot, 0.3), again = curve_point(knot, 0.3 + 2 * kPi);
    // The rounding of 2 pi, seven times faster.
    EXPECT_LT(length(first.position - again.position), 1e-13);
    EXPECT_LT(length(first.derivative - again.derivative), 1e-12);
  }
}

TEST(Curve, winds_p_times_about_the_axis_and_q_times_through_the_hole) {
  for (const KnotSpec& knot : kKnots) {
    double about = 0, through = 0;
    const int n = 1000;  // each step turns by far less than pi
    for (int i = 0; i < n; ++i) {
      const Vec3d a = curve_point(knot, 2 * kPi * i / n).position;
      const Vec3d b = curve_point(knot, 2 * kPi * (i + 1) / n).position;
      about += std::remainder(std::atan2(b.y, b.x) - std::atan2(a.y, a.x), 2 * kPi);
      const auto angle = [&](const Vec3d& c) {
        return std::atan2(c.z, std::hypot(c.x, c.y) - knot.ring_radius);
      };
      through += std::remainder(angle(b) - angle(a), 2 * kPi);
    }
    EXPECT_NEAR(about / (2 * kPi), knot.p, 1e-9);  // a sum of n roundings; the answer is whole
    EXPECT_NEAR(through / (2 * kPi), knot.q, 1e-9);
  }
}

TEST(Curve, derivative_never_vanishes) {
  for (const KnotSpec& knot : kKnots) {
    for (int i = 0; i < 97; ++i) {
      EXPECT_GT(length(curve_point(knot, 0.065 * i).derivative), 0.3);  // w |q| or (R - w) |p|
    }
  }
}

TEST(Curve, derivative_is_the_limit_of_central_differences_at_order_2) {
  for (const KnotSpec& knot : kKnots) {
    const double order = std::log2(difference_error(knot, 2e-3) / difference_error(knot, 1e-3));
    EXPECT_NEAR(order, 2, 0.01);  // the next term of the error is h^2 smaller
  }
}

TEST(Curve, unknotted_ring_is_a_circle_with_its_exact_length) {
  // (1,0) runs along the torus's outermost circle, of radius R + w.
  const double exact = 2 * kPi * 1.4;
  for (const int samples : {3, 10, 4096}) {
    EXPECT_NEAR(curve_length(knot_of(1, 0), samples), exact, 1e-12 * exact);  // rounding of a sum
    EXPECT_NEAR(curve_length(knot_of(-1, 0), samples), exact, 1e-12 * exact);
  }
}

TEST(Curve, unknotted_winding_is_a_circle_with_its_exact_length) {
  const double exact = 2 * kPi * 0.4;
  EXPECT_NEAR(curve_length(knot_of(0, 1)), exact, 1e-12 * exact);
  EXPECT_NEAR(curve_length(knot_of(0, -1)), exact, 1e-12 * exact);
}

TEST(Curve, length_converges_faster_than_any_power) {
  for (const auto& [p, q] : {std::pair{2, 3}, {5, 2}, {3, -7}}) {
    const double fine = curve_length(knot_of(p, q), 8192);
    EXPECT_NEAR(curve_length(knot_of(p, q), 512), fine, 1e-11 * fine);  // rounding of 8192 terms
  }
}

TEST(Curve, length_is_that_of_a_fine_polygon) {
  const KnotSpec knot = knot_of(2, 3);
  double polygon = 0;
  const int n = 20'000;
  for (int i = 0; i < n; ++i) {
    polygon += length(curve_point(knot, 2 * kPi * (i + 1) / n).position -
                      curve_point(knot, 2 * kPi * i / n).position);
  }
  // A chord is shorter than its arc by (curvature x arc)^2 / 24, here below 1e-7.
  EXPECT_NEAR(polygon / curve_length(knot), 1, 1e-7);
  EXPECT_LT(polygon, curve_length(knot));
}

TEST(Curve, length_is_the_same_for_mirror_images_and_reversals) {
  const double exact = curve_length(knot_of(2, 3));
  for (const auto& [p, q] : {std::pair{-2, 3}, {2, -3}, {-2, -3}}) {
    EXPECT_NEAR(curve_length(knot_of(p, q)), exact, 1e-12 * exact);  // rounding of a sum
  }
}

TEST(Curve, length_scales_with_the_lengths) {
  for (const double scale : {1e-3, 1e6}) {
    KnotSpec knot = knot_of(2, 3);
    const double exact = curve_length(knot) * scale;
    knot.ring_radius *= scale;
    knot.winding_radius *= scale;
    EXPECT_NEAR(curve_length(knot), exact, 1e-12 * exact);  // rounding of a sum
  }
}

}  // namespace
}  // namespace lumaknot
