// Light computed at vertices and interpolated, against light computed at every pixel.
#include <gtest/gtest.h>

#include "render/reference.h"
#include "shaders/formulas/lighting.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

Shot shot_of(Stage stage, ShadingFrequency rate, Material material = {}) {
  material.rate = rate;
  return {"shot", stage, material};
}

/// A square seen at a slant, so that perspective bends what is not interpolated in space.
Scene square_scene(const Light& light) {
  Scene scene{testing::square(1), Vec3d{0.6, 0.4, 0.2}, {}};
  scene.view.camera = {.position = {0.4, -2, 1.5}, .target = {0, 0, 0}, .fov_degrees = 60};
  scene.view.lights = {light};
  scene.view.image = {48, 36, 1};
  return scene;
}

template <class F>
void for_each_seen(const Scene& scene, F check) {
  int count = 0;
  for (const Fragment& fragment : visible_fragments(scene).pixels) {
    if (!fragment.covered()) continue;
    ++count;
    check(fragment);
  }
  EXPECT_GT(count, 100);
}

TEST(ShadingFrequency, of_a_directional_light_on_a_flat_lambert_surface_does_not_matter) {
  const Scene scene = square_scene(DirectionalLight{{0.3, 0.5, -1}, {{1, 0.5, 0.25}, 1}});
  const Shot at_vertices = shot_of(Stage::kDiffuse, ShadingFrequency::kVertex);
  const Shot at_pixels = shot_of(Stage::kDiffuse, ShadingFrequency::kPixel);
  for_each_seen(scene, [&](const Fragment& f) {
    // The weights add up to one, except for rounding.
    EXPECT_LT(length(shade(scene, at_vertices, f) - shade(scene, at_pixels, f)), 1e-14);
  });
}

TEST(ShadingFrequency, of_a_directional_light_gives_the_same_final_image_in_every_space) {
  Material m;
  m.specular = 0;
  for (const Space space : {Space::kRgb, Space::kYiq, Space::kCielab, Space::kDin99}) {
    m.space = space;
    const Scene scene = square_scene(DirectionalLight{{0.3, 0.5, -1}, {}});
    for_each_seen(scene, [&](const Fragment& f) {
      const Vec3d at_vertices =
          shade(scene, shot_of(Stage::kFinal, ShadingFrequency::kVertex, m), f);
      const Vec3d at_pixels = shade(scene, shot_of(Stage::kFinal, ShadingFrequency::kPixel, m), f);
      EXPECT_LT(length(at_vertices - at_pixels), 1e-13);  // rounding, times 12.92 near black
    });
  }
}

/// A fragment at a triangle's corner or between corners.
Fragment fragment_at(const Scene& scene, std::uint32_t triangle,
                     const std::array<double, 3>& weights) {
  Fragment f;
  f.triangle = triangle;
  f.weights = weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = scene.mesh.triangles[triangle][i];
    f.position = f.position + scene.mesh.positions[v] * weights[i];
    f.normal = f.normal + scene.mesh.normals[v] * weights[i];
    f.uv = {f.uv.u + scene.mesh.uvs[v].u * weights[i], f.uv.v + scene.mesh.uvs[v].v * weights[i]};
  }
  return f;
}

Scene sphere_scene(int rings) {
  Scene scene{testing::sphere(rings), Vec3d{0.6, 0.4, 0.2}, {}};
  scene.view.image = {65, 65, 1};  // odd: a pixel's centre lies on the camera's axis
  return scene;
}

TEST(ShadingFrequency, at_vertices_is_exact_at_the_vertices) {
  const Scene scene = sphere_scene(6);
  for (const Stage stage : {Stage::kDiffuse, Stage::kSpecular}) {
    for (std::uint32_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::array<double, 3> weights{};
        weights[corner] = 1;
        const Fragment f = fragment_at(scene, t, weights);
        EXPECT_EQ(shade(scene, shot_of(stage, ShadingFrequency::kVertex), f),
                  shade(scene, shot_of(stage, ShadingFrequency::kPixel), f));
      }
    }
  }
}

TEST(ShadingFrequency, at_vertices_is_linear_between_them) {
  const Scene scene = sphere_scene(6);
  const std::array<double, 3> weights{0.5, 0.3, 0.2};
  for (const Stage stage : {Stage::kDiffuse, Stage::kSpecular}) {
    const Shot shot = shot_of(stage, ShadingFrequency::kVertex),
               at_pixels = shot_of(stage, ShadingFrequency::kPixel);
    for (std::uint32_t t = 0; t < scene.mesh.triangles.size(); t += 5) {
      Vec3d expected;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::array<double, 3> one{};
        one[corner] = 1;
        expected = expected + shade(scene, at_pixels, fragment_at(scene, t, one)) * weights[corner];
      }
      const Vec3d found = shade(scene, shot, fragment_at(scene, t, weights));
      EXPECT_LT(length(found - expected), 1e-15);  // the same sum
    }
  }
}

TEST(ShadingFrequency, of_a_seen_fragment_uses_the_weights_of_its_place) {
  const Scene scene = sphere_scene(8);
  for_each_seen(scene, [&](const Fragment& f) {
    EXPECT_NEAR(f.weights[0] + f.weights[1] + f.weights[2], 1, 1e-12);
    const Fragment again = fragment_at(scene, std::uint32_t(f.triangle), f.weights);
    EXPECT_LT(length(again.position - f.position), 1e-12);
  });
}

TEST(ShadingFrequency, at_vertices_misses_a_highlight_between_them) {
  // A coarse sphere lit and seen along the middle of a facet: the highlight lies inside it.
  Scene scene = sphere_scene(5);
  const Vec3d middle = normalize(fragment_at(scene, 23, {1.0 / 3, 1.0 / 3, 1.0 / 3}).position);
  scene.view.camera.position = middle * 4.0;
  scene.view.lights = {DirectionalLight{-middle, {}}};
  const Image at_pixels = shade_all(scene, shot_of(Stage::kSpecular, ShadingFrequency::kPixel),
                                    visible_fragments(scene));
  const Image at_vertices = shade_all(scene, shot_of(Stage::kSpecular, ShadingFrequency::kVertex),
                                      visible_fragments(scene));
  const auto brightest = [](const Image& image) {
    float max = 0;
    for (const RgbaPixel& p : image.pixels) max = std::max(max, p.color.r);
    return max;
  };
  EXPECT_GT(brightest(at_pixels), 0.99f);
  EXPECT_LT(brightest(at_vertices), 0.5f) << brightest(at_vertices);
}

TEST(ShadingFrequency, at_vertices_converges_to_light_at_pixels) {
  const auto difference = [](int rings) {
    const Scene scene = sphere_scene(rings);
    double sum = 0;
    int count = 0;
    for_each_seen(scene, [&](const Fragment& f) {
      const Vec3d apart = shade(scene, shot_of(Stage::kDiffuse, ShadingFrequency::kVertex), f) -
                          shade(scene, shot_of(Stage::kDiffuse, ShadingFrequency::kPixel), f);
      sum += length(apart);
      ++count;
    });
    return sum / count;
  };
  // Linear interpolation: halving the facets divides by 4, but at the terminator's kink by 2.
  const double coarse = difference(12), fine = difference(24);
  EXPECT_GT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 2.5);
}

}  // namespace
}  // namespace lumaknot
