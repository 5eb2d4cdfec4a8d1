#include "meshgen/sharpest_bend.h"

#include <gtest/gtest.h>

#include "math/angle.h"

namespace lumaknot {
namespace {

/// The largest of n samples over half a period of the meridian angle.
double sampled_curvature(const Curve& curve, int n) {
  double max = 0;
  for (int i = 0; i <= n; ++i) {
    const double psi = kPi * i / n;
    max = std::max(max, curvature(curve_point(curve, (psi - curve.meridian) / curve.q)));
  }
  return max;
}

TEST(SharpestBend, agrees_with_dense_samples) {
  for (const double winding : {1e-3, 0.4, 0.999, 1.0, 1.5, 30.0}) {
    for (const auto& [p, q] : {std::pair{2, 3}, {3, -2}, {1, 0}, {0, 1}, {30, 1}, {1, 30}}) {
      const Curve curve{p, q, 1, winding, 0.3, 0.7};
      const Bend bend = sharpest_bend(curve);
      EXPECT_NEAR(curvature(curve_point(curve, bend.t)), bend.curvature, 1e-12 * bend.curvature);
      if (q == 0) continue;
      const double samples = sampled_curvature(curve, 100'000);
      EXPECT_GE(bend.curvature, samples * (1 - 1e-12)) << p << " " << q << " " << winding;
      // The narrowest feature is w q / (p R) = 1/30 wide; samples miss (3e-5 x 30)^2 of it.
      EXPECT_LE(bend.curvature, samples * (1 + 1e-6)) << p << " " << q << " " << winding;
    }
  }
}

TEST(SharpestBend, of_a_steep_curve_is_near_the_axis) {
  // A thousand turns about the axis for one through the hole: the bend takes one thousandth of the
  // meridian.
  const Curve curve{1000, 1, 1, 1};
  const Bend bend = sharpest_bend(curve);
  const Vec3d place = curve_point(curve, bend.t).position;
  EXPECT_LT(std::hypot(place.x, place.y), 1e-2);
  EXPECT_GE(bend.curvature, sampled_curvature(curve, 1'000'000) * (1 - 1e-12));
}

TEST(SharpestBend, scales_with_the_lengths) {
  const double exact = sharpest_bend({2, 3}).curvature;
  for (const double scale : {1e-200, 1e-3, 1e200}) {
    const double scaled = sharpest_bend({2, 3, scale, 0.4 * scale}).curvature;
    EXPECT_NEAR(scaled * scale, exact, 1e-12 * exact);  // rounding
  }
}

}  // namespace
}  // namespace lumaknot
