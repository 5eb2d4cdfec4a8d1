#include "meshgen/frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "math/angle.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-13;  // a few operations per frame; errors don't accumulate
KnotSpec knot_of(int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  return knot;
}

Spine spine_of(int p, int q) { return Spine(components(knot_of(p, q)).front()); }

std::vector<RingFrame> frames_of(int p, int q, int segments,
                                 FrameRule rule = FrameRule::kRotationMinimizing) {
  const Spine spine = spine_of(p, q);
  return ring_frames(spine, rule, spine.arc_lengths(segments));
}

constexpr FrameRule kRules[] = {FrameRule::kRotationMinimizing, FrameRule::kDoubleReflection,
                                FrameRule::kFrenet, FrameRule::kThree};

const std::pair<int, int> kPairs[] = {{2, 3}, {-2, 3}, {2, -3}, {1, 0}, {0, 1}, {5, 2}, {7, 11}};

/// The twist of two neighbours.
double twist_between(const RingFrame& a, const RingFrame& b) { return twist({a, b}); }

TEST(Frames, are_orthonormal_and_one_handed) {
  for (const auto& [p, q] : kPairs) {
    for (const FrameRule rule : kRules) {
      if (rule == FrameRule::kThree && p == 0) continue;
      for (const RingFrame& f : frames_of(p, q, 500, rule)) {
        ASSERT_NEAR(length(f.tangent), 1, kRounding);
        ASSERT_NEAR(length(f.normal), 1, kRounding);
        ASSERT_NEAR(length(f.binormal), 1, kRounding);
        ASSERT_NEAR(dot(f.normal, f.binormal), 0, kRounding);
        ASSERT_NEAR(dot(f.tangent, f.normal), 0, kRounding);
        ASSERT_NEAR(length(cross(f.normal, f.tangent) - f.binormal), 0, kRounding);
      }
    }
  }
}

TEST(Frames, are_on_the_curve_along_its_tangent) {
  const Curve line = components(knot_of(5, 2)).front();
  const std::vector<RingFrame> frames = frames_of(5, 2, 100);
  ASSERT_EQ(frames.size(), 101u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const CurvePoint point = curve_point(line, ring_parameter(int(i), 100));
    EXPECT_LT(length(frames[i].position - point.position), kRounding);
    EXPECT_LT(length(cross(frames[i].tangent, point.first)), 10 * kRounding);
    EXPECT_GT(dot(frames[i].tangent, point.first), 0);
  }
}

TEST(Frames, close_to_less_than_a_billionth_of_a_degree) {
  for (int p = -7; p <= 7; ++p) {
    for (int q = -7; q <= 7; ++q) {
      if (std::gcd(p, q) != 1) continue;
      const std::vector<RingFrame> frames = frames_of(p, q, 200);
      const double error = length(frames.front().normal - frames.back().normal);
      ASSERT_LT(error * 180 / kPi, 1e-9) << p << "," << q;
    }
  }
}

TEST(Frames, distribute_the_holonomy_evenly_by_arc_length) {
  for (const auto& [p, q] : kPairs) {
    const Spine spine = spine_of(p, q);
    const std::vector<RingFrame> frames = frames_of(p, q, 768);
    for (int i = 0; i < 768; ++i) {
      const double way =
          spine.arc_length(ring_parameter(i + 1, 768)) - spine.arc_length(ring_parameter(i, 768));
      // One step of the double reflection that measures it has an error of about (step)^5.
      ASSERT_NEAR(twist_between(frames[std::size_t(i)], frames[std::size_t(i) + 1]),
                  -spine.holonomy() * way / spine.length(), 1e-7)
          << p << "," << q << " ring " << i;
    }
  }
}

TEST(Frames, of_a_plane_circle_do_not_twist_at_all) {
  for (const auto& [p, q] : {std::pair{1, 0}, {0, 1}, {-1, 0}}) {
    EXPECT_EQ(spine_of(p, q).holonomy(), 0);
    EXPECT_NEAR(twist(frames_of(p, q, 100)), 0, 1e-12);  // rounding of 100 steps
  }
}

/// The largest error of a normal found by double reflection.
double reflection_error(int p, int q, int segments) {
  const std::vector<RingFrame> exact = frames_of(p, q, segments);
  const auto steps = frames_of(p, q, segments, FrameRule::kDoubleReflection);
  double worst = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    worst = std::max(worst, length(steps[i].normal - exact[i].normal));
  }
  return worst;
}

TEST(Frames, of_double_reflection_converge_to_the_exact_ones_at_order_4) {
  for (const auto& [p, q] : {std::pair{2, 3}, {5, 2}, {3, -4}}) {
    const double coarse = reflection_error(p, q, 400), middle = reflection_error(p, q, 800),
                 fine = reflection_error(p, q, 1600);
    // Order 4 (Wang et al. 2008, section 4.2); higher terms bend the slope at a finite step.
    EXPECT_NEAR(std::log2(coarse / middle), 4, 0.1) << p << "," << q;
    EXPECT_NEAR(std::log2(middle / fine), 4, 0.1) << p << "," << q;
  }
}

TEST(Frames, holonomy_is_the_total_torsion) {
  // The rotation-minimising frame turns relative to the Frenet frame by minus the torsion, and the
  // Frenet frame of these knots closes: the missing angle is the integral of torsion over the loop.
  for (const auto& [p, q] : {std::pair{2, 3}, {3, 2}, {5, 2}, {-3, 5}}) {
    const Curve line = components(knot_of(p, q)).front();
    const int n = 8000;
    double total = 0;
    for (int i = 0; i < n; ++i) {
      const CurvePoint point = curve_point(line, ring_parameter(i, n));
      total += torsion(point) * length(point.first) * 2 * kPi / n;
    }
    // From normal to binormal is a rotation about minus the tangent, hence plus the torsion. The
    // trapezoid rule is exact to rounding on a smooth closed curve.
    const double holonomy = spine_of(p, q).holonomy();
    EXPECT_NEAR(std::remainder(holonomy + total, 2 * kPi), 0, 1e-9) << p << "," << q;
  }
}

TEST(Frames, of_a_mirror_image_close_by_the_opposite_angle) {
  EXPECT_NEAR(spine_of(2, 3).holonomy(), -spine_of(2, -3).holonomy(), kRounding);
}

TEST(Frames, do_not_depend_on_the_unit_of_length) {
  KnotSpec knot = knot_of(2, 3);
  knot.major_radius *= 1e6;
  knot.minor_radius *= 1e6;
  const Spine large(components(knot).front());
  EXPECT_NEAR(large.holonomy(), spine_of(2, 3).holonomy(), kRounding);
  EXPECT_NEAR(large.length() / spine_of(2, 3).length(), 1e6, 1e-6);  // rounding
}

// Known properties of three.js's frames, from the definitions of the curve and the rings.
TEST(Frames, of_three_are_tilted_and_twist_by_known_amounts) {
  const auto spine = [](int p, int q) {
    KnotSpec knot = knot_of(p, q);
    knot.minor_radius = 0.5;
    return Spine(components(knot).front());
  };
  const auto three_frames = [](const Spine& s) {
    return ring_frames(s, FrameRule::kThree, s.arc_lengths(4000));
  };
  const auto tilt = [&](int p, int q) {
    double worst = 0;
    const Spine s = spine(p, q);
    const std::vector<RingFrame> frames = three_frames(s);
    for (int i = 0; i < 4000; ++i) {
      const RingFrame& f = frames[std::size_t(i)];
      const Vec3d tangent = normalize(curve_point(s.curve(), ring_parameter(i, 4000)).first);
      worst = std::max(worst, std::asin(length(cross(cross(f.binormal, f.normal), tangent))));
    }
    return worst * 180 / kPi;
  };
  const auto turns = [&](int p, int q) {
    return std::abs(twist(three_frames(spine(p, q)))) * 180 / kPi;
  };
  EXPECT_NEAR(tilt(2, 3), 0.47, 0.005);  // the figures are known to these digits
  EXPECT_NEAR(tilt(1, 20), 5.7, 0.05);
  EXPECT_NEAR(turns(2, 3), 187, 0.5);
  EXPECT_NEAR(turns(2, 9), 1931, 0.5);
}

std::string refusal(const KnotSpec& knot, FrameRule rule) {
  const Spine spine(components(knot).front());
  return error_of([&] { ring_frames(spine, rule, spine.arc_lengths(401)); });
}

TEST(Frames, of_frenet_are_refused_where_the_curvature_is_zero) {
  KnotSpec knot = knot_of(2, 3);
  knot.minor_radius = 4.0 / 13;  // w q^2 = (R - w) p^2: no curvature where psi = pi
  EXPECT_LT(curvature(curve_point(components(knot).front(), kPi / 3)), 1e-12);
  EXPECT_THAT(refusal(knot, FrameRule::kFrenet), ::testing::HasSubstr("\"frenet\" are undefined"));
  EXPECT_THAT(refusal(knot, FrameRule::kFrenet), ::testing::HasSubstr("rotation-minimizing"));
  EXPECT_EQ(refusal(knot_of(2, 3), FrameRule::kFrenet), "");
}

TEST(Frames, with_a_fixed_up_are_refused_where_the_centre_line_is_vertical) {
  EXPECT_THAT(refusal(knot_of(0, 1), FrameRule::kFixedUp), ::testing::HasSubstr("undefined"));
  EXPECT_EQ(refusal(knot_of(2, 3), FrameRule::kFixedUp), "");
}

}  // namespace
}  // namespace lumaknot
