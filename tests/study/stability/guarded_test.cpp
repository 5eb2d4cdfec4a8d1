// What must never break: our own meshes, formulas and renderers over the whole of what the atlas
// sweeps give numbers, or refuse.
#include <gtest/gtest.h>

#include "meshgen/knot_mesh.h"
#include "render/fast/renderer.h"
#include "scene/presets.h"
#include "study/stability/test_scenes.h"
#include "system/error.h"

namespace lumaknot::stability {
namespace {

bool all_numbers(const Image& image) {
  return std::ranges::all_of(image.pixels, [](const RgbaPixel& p) {
    return is_finite(to_vec(p.color)) && std::isfinite(p.coverage);
  });
}

/// Colours of all kinds, black, white and pure ones among them.
TextureImage small_texture() {
  TextureImage texture(4, 4);
  for (int i = 0; i < 16; ++i) {
    const float dark = i < 8 ? 1.0f : 0.2f;
    texture.pixels[std::size_t(i)] = {dark * float(i & 1), dark * float(i >> 1 & 1),
                                      dark * float(i >> 2 & 1)};
  }
  return texture;
}

/// Whether both renderers give numbers, in every formula.
testing::AssertionResult draws_numbers(Scene scene) {
  scene.view.image = {12, 12, 1};
  scene.texture = small_texture();
  const Material numbers = scene.view.material;
  for (const std::string& name : formula_names()) {
    scene.view.material = *with_formula(numbers, name);
    Image fast;
    fast::Renderer(scene, {.threads = 1}).draw(fast);
    if (!all_numbers(render(scene))) return testing::AssertionFailure() << name;
    if (!all_numbers(fast)) return testing::AssertionFailure() << name << ", fast";
  }
  return testing::AssertionSuccess();
}

KnotSpec small_knot() {
  KnotSpec knot = sketch_knot();
  knot.segments = 48;
  knot.sides = 8;
  return knot;
}

Scene small_scene() { return knot_scene(small_knot(), Material{}); }

TEST(Guarded, meshes_of_every_p_and_q_to_100_are_numbers) {
  KnotSpec knot;
  knot.segments = 5;
  knot.sides = 3;
  for (knot.p = 0; knot.p <= 100; ++knot.p) {
    for (knot.q = knot.p == 0; knot.q <= 100; ++knot.q) {
      if (knot.p == 0 && knot.q == 0) continue;
      const TriangleMesh mesh = knot_mesh(knot);
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_TRUE(is_finite(mesh.positions[i])) << knot.p << " " << knot.q;
        ASSERT_NEAR(length(mesh.normals[i]), 1, 1e-9) << knot.p << " " << knot.q;  // rounding
      }
    }
  }
  knot.p = knot.q = 0;
  EXPECT_THROW(knot_mesh(knot), Error);
}

TEST(Guarded, pictures_of_grids_from_3_x_3_are_numbers) {
  for (const int segments : {3, 4, 5, 7, 12}) {
    for (const int sides : {3, 4, 6}) {
      KnotSpec knot = small_knot();
      knot.segments = segments;
      knot.sides = sides;
      EXPECT_TRUE(draws_numbers(knot_scene(knot, Material{}))) << segments << " x " << sides;
    }
  }
}

TEST(Guarded, pictures_of_lengths_from_1e_minus_30_to_1e30_are_numbers) {
  for (int exponent = -30; exponent <= 30; exponent += 5) {
    Scene scene = small_scene();
    const double scale = std::pow(10.0, exponent);
    for (Vec3d& p : scene.mesh.positions) p = p * scale;
    scene.view.camera.position = scene.view.camera.position * scale;
    PointLight& light = std::get<PointLight>(scene.view.lights.front());
    light.position = light.position * scale;
    light.falloff = {1, 0.5, 0.25};
    EXPECT_TRUE(draws_numbers(scene)) << scale;
  }
}

TEST(Guarded, pictures_far_from_the_origin_are_numbers) {
  for (const double offset : {1e3, 1e7, 1e12}) {
    Scene scene = small_scene();
    const Vec3d by{offset, -offset, offset};
    for (Vec3d& p : scene.mesh.positions) p = p + by;
    scene.view.camera.position = scene.view.camera.position + by;
    scene.view.camera.target = scene.view.camera.target + by;
    EXPECT_TRUE(draws_numbers(scene)) << offset;
  }
}

TEST(Guarded, pictures_of_every_number_of_a_material_are_numbers) {
  for (const double shininess : {0.0, 1.0, 2.0, 55.0, 1e3, 1e6}) {
    for (const double roughness : {0.04, 0.3, 1.57}) {
      for (const double darkness : {0.0, 0.25, 10.0}) {
        Scene scene = small_scene();
        scene.view.material.parameters["shininess"] = shininess;
        scene.view.material.parameters["roughness"] = roughness;
        scene.view.material.parameters["darkness"] = darkness;
        EXPECT_TRUE(draws_numbers(scene)) << shininess << " " << roughness << " " << darkness;
      }
    }
  }
}

/// The scene with every position `moved`.
template <class F>
Scene with_positions(Scene scene, F moved) {
  for (Vec3d& p : scene.mesh.positions) p = moved(p);
  Camera& camera = scene.view.camera;
  camera.position = moved(camera.position);
  camera.target = moved(camera.target);
  PointLight& light = std::get<PointLight>(scene.view.lights.front());
  light.position = moved(light.position);
  return scene;
}

Image drawn_fast(Scene scene) {
  scene.view.image = {48, 48, 1};
  Image image;
  fast::Renderer(scene, {.threads = 1}).draw(image);
  return image;
}

TEST(Guarded, fast_pictures_are_the_same_at_every_scale) {
  const Image plain = drawn_fast(small_scene());
  for (const double scale : {1e-30, 1e-20, 1e-3, 7.0, 1e20, 1e30}) {
    const Image scaled =
        drawn_fast(with_positions(small_scene(), [&](const Vec3d& p) { return p * scale; }));
    EXPECT_LT(rms_difference(scaled, plain), 1e-5) << scale;  // roundings of float
  }
}

TEST(Guarded, fast_pictures_are_the_same_far_from_the_origin) {
  const Image plain = drawn_fast(small_scene());
  const Vec3d by{1e7, 1e7, -1e7};
  const Image moved =
      drawn_fast(with_positions(small_scene(), [&](const Vec3d& p) { return p + by; }));
  EXPECT_LT(rms_difference(moved, plain), 1e-4);  // doubles near 1e7 are 2e-9 apart
}

/// A point that the eye sees on the knot, and where it does.
Vec3d seen_point(const Scene& scene) {
  Vec3d seen;
  share_of(scene, 12, [&](const Fragment& f) {
    seen = f.position;
    return true;
  });
  return seen;
}

TEST(Guarded, pictures_with_lights_on_the_surface_at_the_eye_and_at_infinity_are_numbers) {
  const Scene scene = small_scene();
  const Vec3d eye = scene.view.camera.position;
  for (const Vec3d& position : {seen_point(scene), scene.mesh.positions[0], eye, eye * 1e-9,
                                eye * 1e30, eye * -1e19, Vec3d{}}) {
    for (const Falloff& falloff : {Falloff{1, 0, 0}, Falloff{0, 0, 1}, Falloff{0, 1, 0}}) {
      Scene lit = scene;
      lit.view.lights = {PointLight{position, {}, falloff}};
      EXPECT_TRUE(draws_numbers(lit))
          << position.x << " " << position.y << " " << position.z << ", " << falloff.quadratic;
    }
  }
}

TEST(Guarded, pictures_from_inside_the_tube_and_along_it_are_numbers) {
  const Spine spine(components(small_knot()).front());
  for (const double distance : {0.0, 0.1, 0.18, 0.1801, 0.3}) {
    Scene scene = small_scene();
    const RingFrame frame = spine.frame(0.3);
    scene.view.camera.position = frame.position + frame.normal * distance;
    scene.view.camera.target = scene.view.camera.position + frame.tangent;
    EXPECT_TRUE(draws_numbers(scene)) << distance;
  }
}

}  // namespace
}  // namespace lumaknot::stability
