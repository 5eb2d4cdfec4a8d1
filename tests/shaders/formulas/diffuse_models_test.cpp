// The diffuse terms against their papers, written with angles.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shaders/formulas/terms_at.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;  // a few operations on numbers near one

Material material(Model model, double number = 0) {
  Material m;
  m.model = model;
  m.parameters["roughness"] = m.parameters["darkness"] = number;
  return m;
}

/// Calls `check(light, eye, phi)`: angles from the normal, and between the two azimuths, degrees.
template <class F>
void for_each_angle(F check) {
  for (const double light : {0.0, 1.0, 20.0, 45.0, 70.0, 88.0}) {
    for (const double eye : {0.0, 5.0, 30.0, 60.0, 85.0}) {
      for (const double phi : {0.0, 10.0, 60.0, 90.0, 120.0, 180.0, 290.0}) check(light, eye, phi);
    }
  }
}

double diffuse_at(double light, double eye, double phi, const Material& m) {
  // Azimuths away from the axes; no surface of these models has a grain.
  return terms_at(at_angles(light, 25), at_angles(eye, 25 + phi), m).diffuse;
}

/// Oren and Nayar 1994, eq. 30, over the cosine's rho E_0 / pi; angles in degrees.
double oren_nayar(double light, double eye, double phi, double sigma) {
  const double s2 = sigma * sigma;
  const double a = 1 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
  const double alpha = std::max(light, eye) * kDegree, beta = std::min(light, eye) * kDegree;
  const double along = std::max(0.0, std::cos(phi * kDegree));
  return std::cos(light * kDegree) * (a + b * along * std::sin(alpha) * std::tan(beta));
}

TEST(Lambert, is_the_cosine_whatever_the_eye) {
  for (const Model model : {Model::kPhong, Model::kBlinnPhong, Model::kCookTorrance}) {
    for_each_angle([&](double light, double eye, double phi) {
      EXPECT_NEAR(diffuse_at(light, eye, phi, material(model, 0.5)), std::cos(light * kDegree),
                  kRounding);
    });
  }
}

TEST(OrenNayar, is_equation_30_of_the_paper) {
  for (const double sigma : {0.05, 0.3, 0.7, 1.57}) {
    for_each_angle([&](double light, double eye, double phi) {
      // tan(85 degrees) is 11.4: it multiplies the rounding.
      EXPECT_NEAR(diffuse_at(light, eye, phi, material(Model::kOrenNayar, sigma)),
                  oren_nayar(light, eye, phi, sigma), 12 * kRounding)
          << light << " " << eye << " " << phi << " " << sigma;
    });
  }
}

TEST(OrenNayar, of_a_smooth_surface_is_lambert) {
  for_each_angle([&](double light, double eye, double phi) {
    EXPECT_EQ(diffuse_at(light, eye, phi, material(Model::kOrenNayar, 0)),
              diffuse_at(light, eye, phi, material(Model::kPhong)));
  });
}

TEST(OrenNayar, is_reciprocal_but_for_the_light_s_cosine) {
  for (const double sigma : {0.2, 0.9}) {
    const Material m = material(Model::kOrenNayar, sigma);
    for_each_angle([&](double light, double eye, double phi) {
      // f(l, v) / cos(light) = f(v, l) / cos(eye): Helmholtz.
      EXPECT_NEAR(diffuse_at(light, eye, phi, m) * std::cos(eye * kDegree),
                  diffuse_at(eye, light, -phi, m) * std::cos(light * kDegree), 12 * kRounding);
    });
  }
}

TEST(OrenNayar, a_rough_surface_is_flatter_and_brighter_towards_the_light) {
  const Material rough = material(Model::kOrenNayar, 0.6);
  EXPECT_LT(diffuse_at(0, 0, 0, rough), 1);
  EXPECT_GT(diffuse_at(80, 80, 0, rough), std::cos(80 * kDegree));  // back towards the lamp
  EXPECT_LT(diffuse_at(80, 80, 180, rough), diffuse_at(80, 80, 0, rough));
}

TEST(OrenNayar, light_from_behind_gives_nothing) {
  for (const double sigma : {0.0, 0.5, 1.57}) {
    for (const double light : {90.5, 120.0, 180.0}) {
      EXPECT_EQ(diffuse_at(light, 40, 30, material(Model::kOrenNayar, sigma)), 0);
    }
  }
}

TEST(Minnaert, is_the_product_of_powers_of_both_cosines) {
  for (const double darkness : {0.5, 0.8, 1.3, 2.0, 10.0}) {
    const Material m = material(Model::kMinnaert, darkness);
    for_each_angle([&](double light, double eye, double phi) {
      const double cos_light = std::cos(light * kDegree), cos_eye = std::cos(eye * kDegree);
      // Minnaert 1941: (cos i)^k (cos e)^(k-1); at 88 and 85 degrees their product is 3e-3.
      const double expected = std::pow(cos_light, darkness) * std::pow(cos_eye, darkness - 1);
      EXPECT_NEAR(diffuse_at(light, eye, phi, m) / expected, 1, 1e-12);  // cosines near 0.03
    });
  }
}

TEST(Minnaert, of_darkness_one_is_lambert) {
  for_each_angle([&](double light, double eye, double phi) {
    EXPECT_EQ(diffuse_at(light, eye, phi, material(Model::kMinnaert, 1)),
              diffuse_at(light, eye, phi, material(Model::kPhong)));
  });
}

TEST(Minnaert, is_reciprocal_but_for_the_light_s_cosine) {
  const Material m = material(Model::kMinnaert, 0.7);
  for_each_angle([&](double light, double eye, double phi) {
    EXPECT_NEAR(diffuse_at(light, eye, phi, m) * std::cos(eye * kDegree),
                diffuse_at(eye, light, -phi, m) * std::cos(light * kDegree), kRounding);
  });
}

TEST(Minnaert, stays_bounded_towards_the_edge) {
  // Where the product of the cosines is below 1e-4 it is taken as 1e-4.
  const double lit = std::cos(89.9 * kDegree);
  EXPECT_NEAR(diffuse_at(89.9, 89.9, 0, material(Model::kMinnaert, 0.5)), lit * 100, 1e-11);
  EXPECT_EQ(diffuse_at(30, 95, 0, material(Model::kMinnaert, 2)),
            std::cos(30 * kDegree) * 1e-4);  // the eye behind the surface
  EXPECT_EQ(diffuse_at(100, 30, 0, material(Model::kMinnaert, 0.5)), 0);
}

}  // namespace
}  // namespace lumaknot
