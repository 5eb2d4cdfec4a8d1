// The highlights against their papers, written with angles. Phong's: phong_terms_test.cpp.
#include <gtest/gtest.h>

#include "math/angle.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/formulas/terms_at.h"

namespace lumaknot {
namespace {

Material blinn(double shininess) {
  Material m;
  m.model = Model::kBlinnPhong;
  m.parameters["shininess"] = shininess;
  return m;
}

Material cook_torrance(double roughness, double reflectance) {
  Material m;
  m.model = Model::kCookTorrance;
  m.parameters["roughness"] = roughness;
  m.parameters["reflectance"] = reflectance;
  return m;
}

/// The angle between two unit vectors, exact near 0 too.
double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

TEST(Blinn, in_the_mirror_direction_is_one) {
  for (const double shininess : {0.0, 1.0, 55.0, 1000.0}) {
    for (const double theta : {0.0, 30.0, 80.0}) {
      const double highlight =
          terms_at(at_angles(theta, 40), at_angles(theta, 220), blinn(shininess)).specular;
      EXPECT_NEAR(highlight, 1, shininess * 1e-15 + 1e-15);  // the power multiplies the rounding
    }
  }
}

TEST(Blinn, is_the_cosine_of_the_half_angle_to_its_power) {
  for (const double light : {0.0, 20.0, 60.0}) {
    for (const double eye : {10.0, 50.0, 80.0}) {
      // In one plane the half vector lies half way between the angles.
      const double half = (light - eye) / 2 * kDegree;
      EXPECT_NEAR(terms_at(at_angles(light), at_angles(eye, 180), blinn(30)).specular,
                  std::pow(std::cos(half), 30), 30e-15);
    }
  }
}

TEST(Blinn, falls_off_slower_than_phong_by_a_power_of_four) {
  // Near the peak the half angle is half the angle to the mirror direction.
  const double phong = terms_at(at_angles(30), at_angles(31, 180), Material{}).specular;
  const double four_times = terms_at(at_angles(30), at_angles(31, 180), blinn(4 * 55)).specular;
  EXPECT_NEAR(four_times, phong, 1e-6);  // their next terms differ: 55 (1 degree)^4 / 16
}

TEST(Blinn, is_the_same_with_eye_and_light_exchanged) {
  RandomSurface random;
  for (int i = 0; i < 200; ++i) {
    const Vec3d l = random.direction(), v = random.direction();
    EXPECT_NEAR(terms_at(l, v, blinn(20)).specular, terms_at(v, l, blinn(20)).specular, 1e-13);
  }
}

/// Walter et al. 2007, eq. 33, with the angle to the half vector.
double ggx(double theta, double alpha) {
  const double c = std::cos(theta), t = std::tan(theta);
  return alpha * alpha / (kPi * std::pow(c, 4) * std::pow(alpha * alpha + t * t, 2));
}

/// Heitz 2014, eq. 72: of GGX.
double smith_lambda(double theta, double alpha) {
  const double t = std::tan(theta);
  return (-1 + std::sqrt(1 + alpha * alpha * t * t)) / 2;
}

/// Schlick 1994, eq. 15.
double schlick(double theta, double f0) { return f0 + (1 - f0) * std::pow(1 - std::cos(theta), 5); }

/// pi n.l times Cook and Torrance's D G F / (4 n.l n.v), G height-correlated (Heitz 2014, eq. 99).
double microfacets(const Vec3d& l, const Vec3d& v, double roughness, double f0) {
  const Vec3d n{0, 0, 1}, h = normalize(l + v);
  const double alpha = roughness * roughness;
  const double g = 1 / (1 + smith_lambda(angle(n, l), alpha) + smith_lambda(angle(n, v), alpha));
  const double d = ggx(angle(n, h), alpha), f = schlick(angle(l, h), f0);
  return kPi * d * g * f / (4 * std::cos(angle(n, v)));
}

/// Calls `check(l, v)` for directions above the surface, the mirror direction among them.
template <class F>
void for_each_pair(F check) {
  for (const double light : {0.0, 25.0, 55.0, 80.0}) {
    for (const double eye : {0.0, 25.0, 40.0, 85.0}) {
      for (const double phi : {0.0, 35.0, 110.0, 175.0, 180.0}) {
        check(at_angles(light, 70), at_angles(eye, 70 + phi));
      }
    }
  }
}

TEST(CookTorrance, is_ggx_smith_and_schlick) {
  for (const double roughness : {0.04, 0.1, 0.3, 0.7, 1.0, 1.57}) {
    for (const double f0 : {0.0, 0.04, 0.5, 1.0}) {
      for_each_pair([&](const Vec3d& l, const Vec3d& v) {
        const double expected = microfacets(l, v, roughness, f0);
        // Relative: a few operations. At the peak of a mirror tan(angle) must be known to 1e-16 of
        // alpha 0.0016. Without reflectance 1 - cos loses digits, which the fifth power multiplies.
        const double exact = terms_at(l, v, cook_torrance(roughness, f0)).specular;
        EXPECT_NEAR(exact, expected, 1e-11 * expected + 1e-15)
            << roughness << " " << f0 << " " << l.x << " " << v.x;
      });
    }
  }
}

TEST(CookTorrance, over_the_light_s_cosine_is_reciprocal) {
  for (const double roughness : {0.1, 0.5, 1.2}) {
    const Material m = cook_torrance(roughness, 0.04);
    for_each_pair([&](const Vec3d& l, const Vec3d& v) {
      const double one_way = terms_at(l, v, m).specular / l.z;
      const double other_way = terms_at(v, l, m).specular / v.z;
      EXPECT_NEAR(one_way, other_way, 1e-12 * one_way);  // relative rounding
    });
  }
}

TEST(CookTorrance, of_a_perfect_mirror_head_on_is_its_reflectance_over_four_alpha_squared) {
  // D = 1 / (pi alpha^2), G = 1, F = F0, times pi / 4.
  for (const double roughness : {0.2, 0.5}) {
    const double expected = 0.3 / (4 * std::pow(roughness, 4));
    EXPECT_NEAR(terms_at({0, 0, 1}, {0, 0, 1}, cook_torrance(roughness, 0.3)).specular, expected,
                1e-12 * expected);
  }
}

TEST(CookTorrance, light_from_behind_gives_no_highlight) {
  for (const double theta : {90.5, 120.0, 179.0}) {
    EXPECT_EQ(terms_at(at_angles(theta), at_angles(30, 180), cook_torrance(0.3, 1)).specular, 0);
  }
}

TEST(Highlights, gated_are_gone_where_the_light_is_behind_and_the_same_in_front) {
  RandomSurface random;
  int behind = 0, shown_before = 0;
  for (const Model model : {Model::kPhong, Model::kBlinnPhong, Model::kMinnaert, Model::kOrenNayar,
                            Model::kCookTorrance}) {
    Material m;
    m.model = model;
    m.parameters["shininess"] = 2;
    for (int i = 0; i < 200; ++i) {
      const Vec3d l = random.direction(), v = random.direction();
      m.highlights = Highlights::kFree;
      const GreyTerms free = terms_at(l, v, m);
      m.highlights = Highlights::kGated;
      const GreyTerms gated = terms_at(l, v, m);
      EXPECT_EQ(gated.diffuse, free.diffuse);
      EXPECT_EQ(gated.specular, l.z > 0 ? free.specular : 0);
      behind += l.z <= 0;
      shown_before += l.z <= 0 && free.specular > 0;
    }
  }
  EXPECT_GT(behind, 300);        // of 1000
  EXPECT_GT(shown_before, 100);  // so the gate had something to do
}

TEST(Highlights, gated_are_gone_where_the_light_grazes_the_surface) {
  Material m;
  m.parameters["shininess"] = 1;
  const Vec3d l{1, 0, 0}, v{-0.6, 0, 0.8};
  EXPECT_NEAR(terms_at(l, v, m).specular, 0.6, 1e-15);
  m.highlights = Highlights::kGated;
  EXPECT_EQ(terms_at(l, v, m).specular, 0);
}

}  // namespace
}  // namespace lumaknot
