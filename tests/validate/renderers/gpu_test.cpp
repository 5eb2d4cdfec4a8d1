// The emitted shaders as OpenGL and Vulkan draw them, against our own image.
#include <gmock/gmock.h>

#include <cmath>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "validate/compare/images.h"
#include "validate/renderers/entry.h"
#include "validate/run.h"

namespace lumaknot::validate {
namespace {

Programs programs() {
  Programs result;
  result.paths[kGpuProgram.flag] = LUMAKNOT_GPU;
  return result;
}

Scene scene_of(const SceneSpec& spec) {
  return {knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), spec.view};
}

Shot final_shot(const std::string& formula) {
  return {formula, Stage::kFinal, *with_formula(Material{}, formula)};
}

/// By the renderer's name.
class EmittedShaders : public ::testing::TestWithParam<const char*> {
 protected:
  Rendering draw(const Scene& scene, const std::vector<Shot>& shots) {
    return renderer_entry(GetParam()).make(programs())->draw(scene, shots);
  }
};

/// The largest difference of the two images' 8-bit values, in steps, inside.
double eight_bit_steps(const Reference& reference, const Image& a, const Image& b) {
  double max = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i].coverage != b.pixels[i].coverage || reference.silhouettes.pixels[i]) continue;
    const Rgb &p = a.pixels[i].color, &q = b.pixels[i].color;
    for (const auto& [x, y] : {std::pair(p.r, q.r), std::pair(p.g, q.g), std::pair(p.b, q.b)}) {
      const auto step = [](float v) { return std::round(255 * std::clamp(v, 0.0f, 1.0f)); };
      max = std::max(max, double(std::abs(step(x) - step(y))));
    }
  }
  return max;
}

TEST_P(EmittedShaders, draw_figure2_as_we_do) {
  const Scene scene = scene_of(*builtin_scene("figure2"));
  const Grid<Fragment> fragments = visible_fragments(scene);
  const Reference reference(scene, fragments);
  const std::vector<Shot> shots{final_shot("rgb-phong"), final_shot("yiq-table1-phong"),
                                final_shot("yiq-phong"), final_shot("yiq-collapsed-phong")};
  const Rendering rendering = draw(scene, shots);
  // 1/128 pixel: vertices are snapped to 1/256. 2e-4: what this project promises in float; beyond
  // it a pixel must be at a texel's edge or have moved by so much.
  const Standard standard{.promise = {.grid_bits = 7}, .limits = {.max = 2e-4}};
  for (std::size_t i = 0; i < shots.size(); ++i) {
    ASSERT_EQ(rendering.shots[i].status, RenderedShot::Status::kDrawn) << rendering.shots[i].why;
    const Image ours = shade_all(scene, shots[i], fragments);
    const Image& theirs = rendering.shots[i].image;
    const Comparison c = compare(reference, shots[i], ours, theirs, {}, standard);
    EXPECT_GT(c.inside, 100'000) << "the knot fills a good part of the image";
    EXPECT_LE(c.coverage_differs, 5) << shots[i].name;
    EXPECT_LE(eight_bit_steps(reference, ours, theirs), 1) << shots[i].name;
    // Where a silhouette's triangles are thinner than the grid their plane turns.
    EXPECT_LE(c.classes[std::size_t(PixelClass::kUnexplained)], 2) << shots[i].name;
    for (const PixelPlace& place : c.unexplained) {
      EXPECT_TRUE(reference.silhouettes.at(place.x, place.y)) << place.x << ", " << place.y;
    }
    EXPECT_LE(c.outliers, 500) << "texel edges are few: 0.3 % of the pixels";
  }
}

/// Figure 2 small, with lights of every kind.
Scene lights_of_every_kind() {
  SceneSpec spec = *builtin_scene("figure2");
  auto& knot = std::get<KnotSpec>(spec.mesh);
  knot.segments = 200;
  knot.sides = 20;
  spec.view.image = {160, 120, 1};
  PointLight point;
  point.falloff = {0.5, 0.1, 0.05};
  point.color = {{1, 0.8, 0.6}, 1.5};
  DirectionalLight directional;
  directional.direction = {-1, 1, -0.5};
  directional.color = {{0.3, 0.5, 1}, 0.4};
  SpotLight spot;
  spot.position = {2, -2, 3};
  spot.direction = {-2, 2, -3};
  spec.view.lights = {point, directional, spot};
  spec.view.ambient_color = {0.5, 1, 0.5};
  Scene scene = scene_of(spec);
  return scene;
}

TEST_P(EmittedShaders, draw_every_formula_gamut_rate_and_light_as_we_do) {
  const Scene scene = lights_of_every_kind();
  std::vector<Shot> shots;
  for (const std::string& name : formula_names()) {
    Shot shot = final_shot(name);
    shot.material.emissive = {0.05, 0, 0.1};
    shot.material.specular_color = {1, 0.9, 0.5};
    shot.material.gamut = Gamut(shots.size() % 3);
    shot.material.highlights = Highlights(shots.size() % 2);
    shot.material.rate = ShadingFrequency(shots.size() / 2 % 2);
    shots.push_back(shot);
  }
  const Grid<Fragment> fragments = visible_fragments(scene);
  const Reference reference(scene, fragments);
  const Rendering rendering = draw(scene, shots);
  // 1/128 pixel as above. At most 1e-3 without a class: ATD95 and the roots of the CIE spaces take
  // float32 roundings of 1e-5 apart, times the texture's steps where a sample moved within a texel.
  const Standard standard{.promise = {.grid_bits = 7}, .limits = {.max = 1e-3}};
  for (std::size_t i = 0; i < shots.size(); ++i) {
    ASSERT_EQ(rendering.shots[i].status, RenderedShot::Status::kDrawn)
        << shots[i].name << ": " << rendering.shots[i].why;
    const Comparison c = compare(reference, shots[i], shade_all(scene, shots[i], fragments),
                                 rendering.shots[i].image, {}, standard);
    EXPECT_LE(c.coverage_differs, 2) << shots[i].name;
    EXPECT_LE(c.mean, 1e-4) << shots[i].name;
    EXPECT_EQ(c.classes[std::size_t(PixelClass::kUnexplained)], 0)
        << shots[i].name << ": " << c.max << " at " << c.max_at.x << ", " << c.max_at.y;
  }
}

TEST_P(EmittedShaders, draw_textures_baked_into_several_spaces) {
  const Scene scene = lights_of_every_kind();
  std::vector<Shot> shots{final_shot("yiq-baked-phong"), final_shot("yuv709-phong"),
                          final_shot("rgb-phong")};
  shots[1].material.form = Form::kBaked;
  const Rendering rendering = draw(scene, shots);
  const Grid<Fragment> fragments = visible_fragments(scene);
  const Reference reference(scene, fragments);
  const Standard standard{.promise = {.grid_bits = 7}, .limits = {.max = 1e-3}};
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Comparison c = compare(reference, shots[i], shade_all(scene, shots[i], fragments),
                                 rendering.shots[i].image, {}, standard);
    EXPECT_LE(c.mean, 1e-4) << shots[i].name << ": float32 and snapped vertices";
  }
}

TEST_P(EmittedShaders, draw_a_plain_colour_without_a_light) {
  Scene scene = lights_of_every_kind();
  scene.texture = Vec3d{0.2, 0.5, 0.7};
  scene.view.lights.clear();
  scene.view.ambient = 0.5;
  const std::vector<Shot> shots{final_shot("yiq-baked-phong"), final_shot("din99-minnaert")};
  const Rendering rendering = draw(scene, shots);
  const Grid<Fragment> fragments = visible_fragments(scene);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Image ours = shade_all(scene, shots[i], fragments);
    const RgbaPixel& mine = ours.at(110, 60);
    ASSERT_EQ(mine.coverage, 1) << "the pixel shows the knot";
    const RgbaPixel& theirs = rendering.shots[i].image.at(110, 60);
    EXPECT_NEAR(theirs.color.r, mine.color.r, 2e-5) << shots[i].name << ": float32";
    EXPECT_NEAR(theirs.color.g, mine.color.g, 2e-5) << shots[i].name;
    EXPECT_NEAR(theirs.color.b, mine.color.b, 2e-5) << shots[i].name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EmittedShaders, ::testing::Values("GL", "GLES", "Vulkan", "HLSL"),
                         [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace lumaknot::validate
