// The light that arrives from each kind of light: falloff, cones, directions, colours, sums.
#include <gtest/gtest.h>

#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/formulas/terms_at.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

constexpr double kRounding = 1e-14;  // a few operations on numbers near one

/// L_D of one light on the origin of a surface that faces +z.
Vec3d diffuse_of(const Light& light, const Material& m = {}) {
  View view;
  view.camera.position = {0, 0, 3};
  view.lights = {light};
  return terms_of(view, {{0, 0, 0}, {0, 0, 1}}, m).diffuse;
}

PointLight point_above(double distance, const Falloff& falloff) {
  return {{0, 0, distance}, {}, falloff};
}

TEST(Falloff, is_one_over_the_polynomial_of_the_distance) {
  EXPECT_NEAR(diffuse_of(point_above(2, {0.5, 0.25, 0.125})).x, 1 / (0.5 + 0.5 + 0.5), kRounding);
  EXPECT_NEAR(diffuse_of(point_above(3, {0, 0, 1})).x, 1.0 / 9, kRounding);
  EXPECT_NEAR(diffuse_of(point_above(4, {0, 1, 0})).x, 0.25, kRounding);
  EXPECT_NEAR(diffuse_of(point_above(4, {2, 0, 0})).x, 0.5, kRounding);
}

TEST(Falloff, by_default_does_not_weaken) {
  for (const double distance : {0.01, 1.0, 1000.0}) {
    EXPECT_EQ(diffuse_of(PointLight{{0, 0, distance}, {}, {}}), grey(1.0));
  }
}

TEST(Falloff, may_brighten_near_the_light) {
  EXPECT_NEAR(diffuse_of(point_above(0.5, {0, 0, 1})).x, 4, kRounding);
}

TEST(Falloff, weakens_highlights_alike) {
  View view;
  view.camera.position = {0, 0, 3};
  view.lights = {PointLight{{0, 0, 2}, {}, {0, 0.25, 0.125}}};
  EXPECT_NEAR(terms_of(view, {{0, 0, 0}, {0, 0, 1}}, Material{}).specular.x, 1, kRounding);
  view.lights = {PointLight{{0, 0, 2}, {}, {0, 0.25, 0.375}}};
  EXPECT_NEAR(terms_of(view, {{0, 0, 0}, {0, 0, 1}}, Material{}).specular.x, 0.5, kRounding);
}

TEST(Directional, shines_along_its_direction_everywhere_alike) {
  EXPECT_NEAR(diffuse_of(DirectionalLight{{0, 0, -7}, {}}).x, 1, kRounding);
  EXPECT_NEAR(diffuse_of(DirectionalLight{{3, 0, -4}, {}}).x, 0.8, kRounding);
  EXPECT_EQ(diffuse_of(DirectionalLight{{0, 0, 1}, {}}), Vec3d{});  // from below
  View view;
  view.lights = {DirectionalLight{{3, 0, -4}, {}}};
  const auto at = [&](const Vec3d& p) {
    return terms_of(view, {p, {0, 0, 1}}, Material{}).diffuse;
  };
  EXPECT_EQ(at({0, 0, 0}), at({100, -50, 7}));
}

TEST(Directional, is_a_point_light_far_away) {
  const Vec3d direction = normalize(Vec3d{-0.5, 1, -2});
  const Vec3d far = diffuse_of(PointLight{direction * -1e9, {}, {}});
  EXPECT_LT(largest_magnitude(diffuse_of(DirectionalLight{direction, {}}) - far), 1e-9);
}

/// A spot one unit from the origin, its axis `degrees` away from the line to it; straight above, so
/// that only the cone attenuates.
double through_cone(double degrees, double inner, double outer) {
  const Vec3d axis = -at_angles(degrees, 33);
  return diffuse_of(SpotLight{{0, 0, 1}, axis * 2.5, inner, outer, {}, {}}).x;
}

TEST(Spot, is_full_within_the_inner_cone) {
  for (const double degrees : {0.0, 10.0, 19.99}) EXPECT_EQ(through_cone(degrees, 20, 35), 1);
}

TEST(Spot, is_dark_beyond_the_outer_cone) {
  for (const double degrees : {35.01, 60.0, 90.0, 180.0}) {
    EXPECT_EQ(through_cone(degrees, 20, 35), 0);
  }
}

TEST(Spot, is_half_at_the_middle_of_the_cosines) {
  const double cosine = (std::cos(20 * kDegree) + std::cos(35 * kDegree)) / 2;
  EXPECT_NEAR(through_cone(std::acos(cosine) / kDegree, 20, 35), 0.5, 1e-13);  // edge 0.12 wide
}

TEST(Spot, is_smoothstep_of_the_cosine_between) {
  for (const double degrees : {21.0, 25.0, 30.0, 34.5}) {
    const double inner = std::cos(20 * kDegree), outer = std::cos(35 * kDegree);
    const double t = (std::cos(degrees * kDegree) - outer) / (inner - outer);
    EXPECT_NEAR(through_cone(degrees, 20, 35), t * t * (3 - 2 * t), 1e-13);
  }
}

TEST(Spot, has_cones_wider_than_a_hemisphere) {
  EXPECT_EQ(through_cone(100, 120, 150), 1);
  EXPECT_EQ(through_cone(170, 120, 150), 0);
}

TEST(Spot, has_the_falloff_of_a_point_light) {
  const SpotLight spot{{0, 0, 2}, {0, 0, -1}, 20, 35, {{0.5, 1, 0.25}, 2}, {0.5, 0.25, 0.125}};
  const PointLight point{spot.position, spot.color, spot.falloff};
  EXPECT_EQ(diffuse_of(spot), diffuse_of(point));
}

TEST(Lights, add_up) {
  for (const Model model : {Model::kPhong, Model::kOrenNayar, Model::kCookTorrance}) {
    Material m;
    m.model = model;
    m.highlights = Highlights::kGated;
    RandomSurface random;
    for (int i = 0; i < 50; ++i) {
      const SurfacePoint<double> point = random.point();
      const View all = every_view().back().view;
      ASSERT_EQ(all.lights.size(), 4u);
      Terms<double> sum{{}, {}};
      for (const Light& light : all.lights) {
        View one = all;
        one.lights = {light};
        const Terms<double> terms = terms_of(one, point, m);
        sum = {sum.diffuse + terms.diffuse, sum.specular + terms.specular};
      }
      const Terms<double> together = terms_of(all, point, m);
      EXPECT_EQ(together.diffuse, sum.diffuse);  // the same additions in the same order
      EXPECT_EQ(together.specular, sum.specular);
    }
  }
}

TEST(Lights, none_leave_no_terms) {
  View view;
  view.lights = {};
  const Terms<double> terms = terms_of(view, {{0, 0, 0}, {0, 0, 1}}, Material{});
  EXPECT_EQ(terms.diffuse, Vec3d{});
  EXPECT_EQ(terms.specular, Vec3d{});
}

TEST(LightColour, is_the_colour_times_the_intensity_in_space_rgb) {
  EXPECT_EQ(diffuse_of(DirectionalLight{{0, 0, -1}, {{0.5, 0.25, 1}, 3}}), (Vec3d{1.5, 0.75, 3}));
}

TEST(LightColour, is_its_relative_brightness_in_a_space_of_brightness) {
  const DirectionalLight light{{0, 0, -1}, {{0.5, 0.25, 1}, 3}};
  Material m;
  m.space = Space::kYuv709;
  const double luma = 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 1;
  EXPECT_LT(largest_magnitude(diffuse_of(light, m) - grey(3 * luma)), kRounding);
  m.space = Space::kYiq;  // the paper's weights add up to 1 + 1e-8, white's brightness
  const double y = 0.29889531 * 0.5 + 0.58662247 * 0.25 + 0.11448223 * 1;
  EXPECT_LT(largest_magnitude(diffuse_of(light, m) - grey(3 * y)), 1e-7);
}

TEST(LightColour, of_grey_light_weakens_alike_in_the_linear_spaces) {
  for (const Space space : {Space::kRgb, Space::kYiq, Space::kYuv601, Space::kYuv709}) {
    Material m;
    m.space = space;
    EXPECT_LT(largest_magnitude(diffuse_of(DirectionalLight{{0, 0, -1}, {{0.5, 0.5, 0.5}, 1}}, m) -
                                grey(0.5)),
              kRounding)
        << name_of(space);
  }
}

}  // namespace
}  // namespace lumaknot
