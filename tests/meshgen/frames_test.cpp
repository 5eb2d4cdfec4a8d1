#include "meshgen/frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "meshgen/curve.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-13;  // a few operations a frame; errors don't add up along it

KnotSpec knot_of(int p, int q, int segments) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.segments = segments;
  return knot;
}

const std::pair<int, int> kPairs[] = {{2, 3}, {-2, 3}, {2, -3}, {1, 0}, {0, 1}, {5, 2}, {7, 11}};

/// The angle by which `b` is twisted against `a`, after the least turn that takes tangent to
/// tangent (about their common normal).
double twist(const Frame& a, const Frame& b) {
  const Vec3d axis = cross(a.tangent, b.tangent);
  const double cosine = dot(a.tangent, b.tangent);
  const Vec3d moved =
      a.across * cosine + cross(axis, a.across) + axis * (dot(axis, a.across) / (1 + cosine));
  return std::atan2(dot(b.across, cross(b.tangent, moved)), dot(b.across, moved));
}

TEST(Frames, are_orthonormal_and_one_handed) {
  for (const auto& [p, q] : kPairs) {
    for (const int segments : {3, 64, 500}) {
      for (const Frame& f : closed_frames(knot_of(p, q, segments))) {
        ASSERT_NEAR(length(f.tangent), 1, kRounding);
        ASSERT_NEAR(length(f.across), 1, kRounding);
        ASSERT_NEAR(length(f.over), 1, kRounding);
        ASSERT_NEAR(dot(f.tangent, f.across), 0, kRounding);
        ASSERT_NEAR(dot(f.tangent, f.over), 0, kRounding);
        ASSERT_NEAR(dot(f.across, f.over), 0, kRounding);
        ASSERT_NEAR(length(cross(f.across, f.tangent) - f.over), 0, kRounding);
      }
    }
  }
}

TEST(Frames, stand_on_the_curve_along_its_tangent) {
  const KnotSpec knot = knot_of(5, 2, 100);
  const std::vector<Frame> frames = closed_frames(knot);
  ASSERT_EQ(frames.size(), 100u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const CurvePoint point = curve_point(knot, 2 * std::numbers::pi * double(i) / 100);
    EXPECT_LT(length(frames[i].position - point.position), kRounding);
    EXPECT_LT(length(cross(frames[i].tangent, point.derivative)), 10 * kRounding);
    EXPECT_GT(dot(frames[i].tangent, point.derivative), 0);
  }
}

TEST(Frames, twist_evenly_and_no_more_from_the_last_to_the_first) {
  for (const auto& [p, q] : kPairs) {
    const std::vector<Frame> frames = closed_frames(knot_of(p, q, 768));
    std::vector<double> twists;
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
      twists.push_back(twist(frames[i], frames[i + 1]));
    }
    const auto [least, most] = std::minmax_element(twists.begin(), twists.end());
    const double seam = twist(frames.back(), frames.front());
    // twist() itself errs by O(step^3) a step; the bound is a thirtieth of an even share of pi.
    const double share = std::numbers::pi / 768;
    EXPECT_NEAR(seam, *least, 0.03 * share) << p << "," << q;
    EXPECT_NEAR(seam, *most, 0.03 * share) << p << "," << q;
    EXPECT_LE(std::abs(seam), 1.03 * share) << p << "," << q;
  }
}

TEST(Frames, of_a_plane_circle_do_not_twist_at_all) {
  for (const auto& [p, q] : {std::pair{1, 0}, {0, 1}}) {
    EXPECT_NEAR(closing_angle(knot_of(p, q, 100)), 0, 1e-12);  // rounding of 100 steps
    const std::vector<Frame> frames = closed_frames(knot_of(p, q, 100));
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
      EXPECT_NEAR(twist(frames[i], frames[i + 1]), 0, 1e-12);
    }
  }
}

TEST(Frames, closing_angle_converges_at_order_4) {
  for (const auto& [p, q] : {std::pair{2, 3}, {5, 2}, {3, -4}}) {
    const double exact = closing_angle(knot_of(p, q, 12'800));
    const auto error = [&, p = p, q = q](int segments) {
      return std::abs(
          std::remainder(closing_angle(knot_of(p, q, segments)) - exact, 2 * std::numbers::pi));
    };
    // Order 4 (Wang et al. 2008, section 4.2); higher terms bend the slope at a finite step.
    EXPECT_NEAR(std::log2(error(400) / error(800)), 4, 0.1) << p << "," << q;
    EXPECT_NEAR(std::log2(error(800) / error(1600)), 4, 0.1) << p << "," << q;
  }
}

TEST(Frames, closing_angle_is_the_total_torsion) {
  // The rotation-minimising frame turns against the Frenet frame by minus the torsion, and the
  // Frenet frame of these knots closes: the angle missing is the integral of torsion over the loop.
  const KnotSpec knot = knot_of(2, 3, 3200);
  const int n = 3200;
  const double h = 2 * std::numbers::pi / n;
  double total = 0;
  for (int i = 0; i < n; ++i) {
    const auto d = [&](double t) { return curve_point(knot, t).derivative; };
    const double t = i * h, e = 1e-3;
    const Vec3d d1 = d(t), d2 = (d(t + e) - d(t - e)) / (2 * e);
    const Vec3d d3 = (d(t + e) - d1 * 2.0 + d(t - e)) / (e * e);
    const Vec3d binormal = cross(d1, d2);
    total += dot(binormal, d3) / dot(binormal, binormal) * length(d1) * h;
  }
  // From `across` to `over` is a turn about minus the tangent, hence plus the torsion. The
  // differences above err by e^2.
  EXPECT_NEAR(std::remainder(closing_angle(knot) - total, 2 * std::numbers::pi), 0, 1e-4);
}

TEST(Frames, of_a_mirror_image_close_by_the_opposite_angle) {
  // Rounding of 400 steps.
  EXPECT_NEAR(closing_angle(knot_of(2, 3, 400)), -closing_angle(knot_of(2, -3, 400)), 1e-12);
}

TEST(Frames, do_not_depend_on_the_unit_of_length) {
  KnotSpec knot = knot_of(2, 3, 200);
  const double angle = closing_angle(knot);
  knot.ring_radius *= 1e6;
  knot.winding_radius *= 1e6;
  EXPECT_NEAR(closing_angle(knot), angle, 1e-12);  // rounding of 200 steps
}

}  // namespace
}  // namespace lumaknot
