#include <gtest/gtest.h>

#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/formulas/terms_at.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;  // a few operations on numbers near one

Material phong(double k, NormalUse use = NormalUse::kUnit) {
  Material m;
  m.parameters["shininess"] = k;
  m.normal = use;
  return m;
}

/// The terms at the origin, seen from and lit along the given directions.
GreyTerms terms(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_eye, double k,
                NormalUse use = NormalUse::kUnit) {
  return terms_at(normal, to_light, to_eye, phong(k, use));
}

TEST(PhongTerms, light_and_eye_along_the_normal_give_one_and_one) {
  for (const double k : {1.0, 55.0, 1000.0}) {
    const auto t = terms({0, 0, 1}, {0, 0, 1}, {0, 0, 1}, k);
    EXPECT_EQ(t.diffuse, 1);
    EXPECT_EQ(t.specular, 1);
  }
}

TEST(PhongTerms, light_at_60_degrees_gives_half_and_its_power) {
  const auto t = terms({0, 0, 1}, {std::sqrt(0.75), 0, 0.5}, {0, 0, 1}, 3);
  EXPECT_NEAR(t.diffuse, 0.5, kRounding);
  EXPECT_NEAR(t.specular, 0.125, kRounding);
}

TEST(PhongTerms, eye_in_the_mirror_direction_sees_the_full_highlight) {
  const auto t = terms({0, 0, 1}, {0.6, 0, 0.8}, {-0.6, 0, 0.8}, 55);
  EXPECT_NEAR(t.diffuse, 0.8, kRounding);
  EXPECT_NEAR(t.specular, 1, 55 * kRounding);  // the power multiplies the rounding
}

TEST(PhongTerms, grazing_light_gives_no_diffuse_but_a_highlight) {
  const auto t = terms({0, 0, 1}, {1, 0, 0}, {-std::sqrt(0.5), 0, std::sqrt(0.5)}, 2);
  EXPECT_EQ(t.diffuse, 0);
  EXPECT_NEAR(t.specular, 0.5, kRounding);  // R = (-1, 0, 0), 45 degrees from the eye
}

TEST(PhongTerms, light_behind_gives_no_diffuse_and_does_not_gate_the_highlight) {
  // L = (0.6, 0, -0.8), R = (-0.6, 0, -0.8); the eye at grazing angle sees 0.6 of it.
  const auto t = terms({0, 0, 1}, {0.6, 0, -0.8}, {-1, 0, 0}, 1);
  EXPECT_EQ(t.diffuse, 0);
  EXPECT_NEAR(t.specular, 0.6, kRounding);
}

TEST(PhongTerms, eye_beyond_90_degrees_from_the_reflection_sees_no_highlight) {
  EXPECT_EQ(terms({0, 0, 1}, {0.8, 0, 0.6}, {0.8, 0, 0.6}, 55).specular, 0);
}

TEST(PhongTerms, unit_normals_do_not_mind_the_length_that_interpolation_left) {
  for (const double size : {0.1, 0.5, 0.9, 1.0}) {
    const auto t = terms({0, 0, size}, {0.6, 0, 0.8}, {0, 0, 1}, 1);
    EXPECT_NEAR(t.diffuse, 0.8, kRounding);
    EXPECT_NEAR(t.specular, 0.8, kRounding);
  }
}

TEST(PhongTerms, interpolated_normals_dim_the_diffuse_term) {
  EXPECT_NEAR(terms({0, 0, 0.5}, {0.6, 0, 0.8}, {0, 0, 1}, 1, NormalUse::kInterpolated).diffuse,
              0.4, kRounding);
}

TEST(PhongTerms, interpolated_normals_bend_the_reflection) {
  // n = 0.8 z, L = (0.6, 0, 0.8): 2 n (n.L) - L = (-0.6, 0, 0.224), then made unit.
  const auto t = terms({0, 0, 0.8}, {0.6, 0, 0.8}, {0, 0, 1}, 1, NormalUse::kInterpolated);
  EXPECT_NEAR(t.specular, 0.224 / std::hypot(0.6, 0.224), kRounding);
}

TEST(PhongTerms, a_very_short_interpolated_normal_turns_the_reflection_round) {
  // n = 0.5 z, L = z: 2 n (n.L) - L = -0.5 z.
  EXPECT_EQ(terms({0, 0, 0.5}, {0, 0, 1}, {0, 0, 1}, 1, NormalUse::kInterpolated).specular, 0);
}

TEST(PhongTerms, shininess_zero_makes_the_highlight_one_everywhere) {
  EXPECT_EQ(terms({0, 0, 1}, {0.6, 0, 0.8}, {0.6, 0, 0.8}, 0).specular, 1);
}

TEST(PhongTerms, lie_between_zero_and_one) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const auto t = grey_terms(random.view(), random.point(), phong(55));
    ASSERT_GE(t.diffuse, 0);
    ASSERT_LE(t.diffuse, 1 + kRounding);
    ASSERT_GE(t.specular, 0);
    ASSERT_LE(t.specular, 1 + 55 * kRounding);
  }
}

TEST(PhongTerms, highlight_is_the_same_with_eye_and_light_exchanged) {
  RandomSurface random;
  for (int i = 0; i < 300; ++i) {
    const SurfacePoint<double> point = random.point();
    View view = random.view();
    const double one_way = grey_terms(view, point, phong(55)).specular;
    std::swap(view.camera.position, std::get<PointLight>(view.lights[0]).position);
    // Reflection keeps angles (Helmholtz); the power multiplies the rounding.
    ASSERT_NEAR(grey_terms(view, point, phong(55)).specular, one_way, 55 * kRounding);
  }
}

TEST(PhongTerms, highlight_does_not_tell_the_normal_s_side) {
  RandomSurface random;
  for (int i = 0; i < 100; ++i) {
    SurfacePoint<double> point = random.point();
    const View view = random.view();
    const double one_side = grey_terms(view, point, phong(55)).specular;
    point.normal = -point.normal;  // R is even in n
    ASSERT_NEAR(grey_terms(view, point, phong(55)).specular, one_side, 55 * kRounding);
  }
}

TEST(PhongTerms, only_directions_matter_not_distances) {
  const SurfacePoint<double> point{{1, 2, 3}, {0, 0, 1}};
  const auto at = [&](double d) {
    View view;
    view.camera.position = point.position + Vec3d{0, 0, 1} * d;
    view.lights = {PointLight{point.position + Vec3d{0.6, 0, 0.8} * d, {}, {}}};
    return grey_terms(view, point, phong(2));
  };
  EXPECT_NEAR(at(0.5).diffuse, at(500).diffuse, 1e-13);  // positions near 500 round more coarsely
  EXPECT_NEAR(at(0.5).specular, at(500).specular, 1e-13);
}

}  // namespace
}  // namespace lumaknot
