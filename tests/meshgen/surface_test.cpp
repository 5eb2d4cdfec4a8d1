#include "meshgen/surface.h"

#include <gtest/gtest.h>

#include <utility>

#include "math/angle.h"

namespace lumaknot {
namespace {

constexpr double kRadius = 0.15;

Spine spine_of(int p, int q) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  return Spine(components(knot).front());
}

const std::pair<int, int> kPairs[] = {{2, 3}, {-3, 5}, {1, 0}, {0, 1}, {5, 2}, {4, 6}};

template <class F>
void for_each_point(F visit) {
  for (double t = 0.05; t < 2 * kPi; t += 0.31) {
    for (double theta = 0.1; theta < 2 * kPi; theta += 0.83) visit(t, theta);
  }
}

TEST(Surface, derivatives_are_the_limits_of_central_differences_at_order_2) {
  for (const auto& [p, q] : kPairs) {
    const Spine spine = spine_of(p, q);
    const TubeSurface tube(spine, kRadius);
    const auto error = [&](double h) {
      double worst = 0;
      for_each_point([&](double t, double theta) {
        const TubePoint x = tube.at(t, theta);
        const Vec3d along = (tube.at(t + h, theta).position - tube.at(t - h, theta).position);
        const Vec3d around = (tube.at(t, theta + h).position - tube.at(t, theta - h).position);
        worst = std::max(
            {worst, length(along / (2 * h) - x.along), length(around / (2 * h) - x.around)});
      });
      return worst;
    };
    EXPECT_NEAR(std::log2(error(2e-3) / error(1e-3)), 2, 0.01) << p << "," << q;  // next term: h^2
  }
}

TEST(Surface, normal_is_unit_and_across_both_tangents) {
  for (const auto& [p, q] : kPairs) {
    const Spine spine = spine_of(p, q);
    const TubeSurface tube(spine, kRadius);
    for_each_point([&](double t, double theta) {
      const TubePoint x = tube.at(t, theta);
      ASSERT_NEAR(length(x.normal), 1, 1e-13);  // rounding
      ASSERT_NEAR(dot(x.normal, x.along), 0, 1e-13 * length(x.along));
      ASSERT_NEAR(dot(x.normal, x.around), 0, 1e-13);
      // Outward: along x around points away from the centre line.
      ASSERT_GT(dot(cross(x.along, x.around), x.normal), 0);
    });
  }
}

TEST(Surface, is_one_radius_from_the_centre_line) {
  const Spine spine = spine_of(2, 3);
  const TubeSurface tube(spine, kRadius);
  for_each_point([&](double t, double theta) {
    const TubePoint x = tube.at(t, theta);
    const Vec3d arm = x.position - curve_point(spine.curve(), t).position;
    ASSERT_LT(length(arm - x.normal * kRadius), 1e-14);  // rounding
  });
}

TEST(Surface, of_the_ring_torus_is_the_closed_form) {
  const Spine spine = spine_of(1, 0);  // a torus of radii 1.4 and 0.15
  const TubeSurface tube(spine, kRadius);
  for_each_point([&](double t, double theta) {
    const double reach = 1.4 + kRadius * std::cos(theta);
    const Vec3d x = tube.at(t, theta).position;
    ASSERT_NEAR(x.x, reach * std::cos(t), 1e-14);  // rounding
    ASSERT_NEAR(x.y, reach * std::sin(t), 1e-14);
    ASSERT_NEAR(std::abs(x.z), kRadius * std::abs(std::sin(theta)), 1e-14);
  });
}

}  // namespace
}  // namespace lumaknot
