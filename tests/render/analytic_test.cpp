// Our images against closed forms: a lit plane, and the unit sphere that meshes converge to.
#include <gtest/gtest.h>

#include "render/reference.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

constexpr int kWidth = 36, kHeight = 24;

Scene plane_scene() {
  Scene scene{testing::square(50), Vec3d{0.6, 0.4, 0.2}, {}};
  scene.view.camera = {.position = {0.5, -2, 3}, .target = {0, 0, 0}, .fov_degrees = 40};
  scene.view.lights = {PointLight{{-1, 1.5, 2}, {}, {}}};
  scene.view.ambient = 0.125;
  scene.view.material.parameters["shininess"] = 7;
  scene.view.material.diffuse = 0.75;
  scene.view.material.specular = 0.5;
  scene.view.image = {kWidth, kHeight, 1};
  return scene;
}

Vec3d lamp(const Scene& scene) { return std::get<PointLight>(scene.view.lights.at(0)).position; }

Vec3d sample_ray(const Scene& scene, int x, int y) {
  return testing::world_ray(scene.view.camera, kWidth, kHeight, x + 0.5, y + 0.5);
}

/// The terms on the plane z = 0: the reflection about +z turns the signs of x and y.
struct PlaneTerms {
  double diffuse, specular;
};
PlaneTerms plane_terms(const Scene& scene, const Vec3d& ground) {
  const Vec3d light = normalize(lamp(scene) - ground);
  const Vec3d eye = normalize(scene.view.camera.position - ground);
  const double cosine = std::max(0.0, eye.z * light.z - eye.x * light.x - eye.y * light.y);
  return {light.z, std::pow(cosine, scene.view.material.parameters["shininess"])};
}

template <class Expect>
void for_each_ground_point(const Scene& scene, Expect expect) {
  const Image image = render(scene);
  const Vec3d eye = scene.view.camera.position;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec3d ray = sample_ray(scene, x, y);
      ASSERT_EQ(image.at(x, y).coverage, 1);
      expect(to_vec(image.at(x, y).color), eye + ray * (-eye.z / ray.z));
    }
  }
}

// The image is float32: half a unit of 2^-23 for values up to 2.
constexpr double kFloat = 2e-7;

TEST(Render, plane_under_a_point_light_is_the_closed_form_of_eq_3) {
  const Scene scene = plane_scene();
  for_each_ground_point(scene, [&](const Vec3d& color, const Vec3d& ground) {
    const auto [diffuse, specular] = plane_terms(scene, ground);
    EXPECT_NEAR(color.x, 0.6 * (0.125 + 0.75 * diffuse) + 0.5 * specular, kFloat);
    EXPECT_NEAR(color.y, 0.4 * (0.125 + 0.75 * diffuse) + 0.5 * specular, kFloat);
    EXPECT_NEAR(color.z, 0.2 * (0.125 + 0.75 * diffuse) + 0.5 * specular, kFloat);
  });
}

TEST(Render, plane_under_a_point_light_in_yiq_moves_every_channel_by_the_same_amount) {
  Scene scene = plane_scene();
  scene.view.material.space = Space::kYiq;
  scene.view.material.luma_offset = -0.05;
  const double luma = 0.29889531 * 0.6 + 0.58662247 * 0.4 + 0.11448223 * 0.2;
  for_each_ground_point(scene, [&](const Vec3d& color, const Vec3d& ground) {
    const auto [diffuse, specular] = plane_terms(scene, ground);
    const double shift = luma * (0.125 + 0.75 * diffuse - 1) + 0.5 * specular - 0.05;
    // The paper's M and W are inverse to each other to 1e-7.
    EXPECT_NEAR(color.x - shift, 0.6, kFloat + 2e-7);
    EXPECT_NEAR(color.y - shift, 0.4, kFloat + 2e-7);
    EXPECT_NEAR(color.z - shift, 0.2, kFloat + 2e-7);
  });
}

TEST(Render, plane_lit_from_below_has_ambient_light_only) {
  Scene scene = plane_scene();
  scene.view.lights = {PointLight{{0, 0, -2}, {}, {}}};
  scene.view.material.specular = 0;
  for_each_ground_point(scene, [&](const Vec3d& color, const Vec3d&) {
    EXPECT_NEAR(color.x, 0.6 * 0.125, kFloat);
    EXPECT_NEAR(color.z, 0.2 * 0.125, kFloat);
  });
}

TEST(Shade, nothing_seen_is_black) {
  const Scene scene = plane_scene();
  EXPECT_EQ(shade(scene, {"final", Stage::kFinal, scene.view.material}, Fragment{}), Vec3d{});
}

/// The nearer point where the ray meets the unit sphere, if it is seen at less than 70 degrees:
/// towards the silhouette the error in depth grows without bound.
std::optional<Vec3d> on_sphere(const Vec3d& origin, const Vec3d& ray) {
  const Vec3d d = normalize(ray);
  const double b = dot(origin, d), discriminant = b * b - dot(origin, origin) + 1;
  if (discriminant <= 0) return std::nullopt;
  const Vec3d p = origin + d * (-b - std::sqrt(discriminant));
  if (-dot(p, d) < 0.34) return std::nullopt;
  return p;
}

/// Mean errors of the position and of the diffuse term against the exact sphere.
struct SphereErrors {
  double position = 0, diffuse = 0;
};
SphereErrors sphere_errors(int rings) {
  Scene scene{testing::sphere(rings), Vec3d{1, 1, 1}, {}};
  scene.view.image = {80, 80, 1};
  const Vec3d eye = scene.view.camera.position, light = lamp(scene);
  const Grid<Fragment> seen = visible_fragments(scene);
  const Shot shot{"diffuse", Stage::kDiffuse, {}};
  SphereErrors errors;
  int count = 0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      const auto exact =
          on_sphere(eye, testing::world_ray(scene.view.camera, 80, 80, x + 0.5, y + 0.5));
      if (!exact) continue;
      ++count;
      const Fragment& fragment = seen.at(x, y);
      errors.position += length(fragment.position - *exact);
      const double diffuse = std::max(0.0, dot(*exact, normalize(light - *exact)));
      errors.diffuse += std::abs(shade(scene, shot, fragment).x - diffuse);
    }
  }
  EXPECT_GT(count, 500);
  return {errors.position / count, errors.diffuse / count};
}

TEST(Render, refined_sphere_converges_with_order_two_in_position_and_shading) {
  SphereErrors coarse = sphere_errors(12);
  for (const int rings : {24, 48, 96}) {
    const SphereErrors fine = sphere_errors(rings);
    // Chords leave a circle by h^2 / 8; halving h divides by 4, within the samples' luck.
    EXPECT_NEAR(std::log2(coarse.position / fine.position), 2, 0.15) << rings;
    EXPECT_NEAR(std::log2(coarse.diffuse / fine.diffuse), 2, 0.15) << rings;
    coarse = fine;
  }
}

}  // namespace
}  // namespace lumaknot
