// The fast renderer's pictures match the reference's.
#include <gtest/gtest.h>

#include "scene/bricks.h"
#include "tests/render/fast/testing.h"

namespace lumaknot::fast {
namespace {

using testing::Difference;
using testing::difference;
using testing::fast_image;
using testing::knot_scene;

/// Floats instead of doubles, and image points snapped to 1/1024 of a pixel: a sample flips where
/// an edge passes within 1/2048 of it, about 1 in 1000 along silhouettes. Inside, 1/255 is half a
/// step of a picture of bytes.
void expect_close(const Scene& scene, const Options& options = {}) {
  const Difference d = difference(render(scene), fast_image(scene, options));
  EXPECT_LE(d.coverage, 2);
  EXPECT_GT(d.covered, 1000);
  EXPECT_LE(d.max, 1.0 / 255);
  EXPECT_LE(d.mean, 1e-4);
}

TEST(Fast, draws_what_the_reference_draws_with_every_set_of_instructions) {
  for (const SimdLevel level : testing::simd_levels()) {
    Options options;
    options.level = level;
    expect_close(knot_scene(), options);
  }
}

// The promise for the paper's frame: a silhouette's pixel flips where an edge passes within 1/2048
// of its centre, at most ten of about 5,000.
TEST(Fast, draws_figure_2_within_what_is_promised) {
  const SceneSpec spec = *builtin_scene("figure2");
  const Scene scene{knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), spec.view};
  const Difference d = difference(render(scene), fast_image(scene));
  EXPECT_LE(d.coverage, 10);
  EXPECT_GT(d.covered, 150'000);
  EXPECT_LE(d.max, 1.0 / 255);
  EXPECT_LE(d.mean, 1e-5);
}

TEST(Fast, draws_every_model) {
  for (const Model model : {Model::kPhong, Model::kBlinnPhong, Model::kMinnaert, Model::kOrenNayar,
                            Model::kCookTorrance}) {
    SCOPED_TRACE(int(model));
    Scene scene = knot_scene();
    scene.view.material.model = model;
    scene.view.material.parameters["darkness"] = 0.7;
    expect_close(scene);
  }
}

TEST(Fast, draws_every_space) {
  for (const Space space : {Space::kRgb, Space::kYiq, Space::kYuv601, Space::kYuv709,
                            Space::kCielab, Space::kCieluv, Space::kDin99, Space::kAtd95}) {
    SCOPED_TRACE(int(space));
    Scene scene = knot_scene();
    scene.view.material.space = space;
    scene.view.material.gamut = Gamut::kClamp;
    expect_close(scene);
  }
}

TEST(Fast, draws_every_form) {
  for (const Form form : {Form::kMatrices, Form::kCollapsed, Form::kBaked}) {
    SCOPED_TRACE(int(form));
    Scene scene = knot_scene();
    scene.view.material.space = Space::kYiq;
    scene.view.material.form = form;
    scene.view.material.clamp = Clamp::kTable1;
    scene.view.material.luma_offset = -0.1;
    scene.view.material.normal = NormalUse::kInterpolated;
    expect_close(scene);
  }
}

TEST(Fast, draws_every_kind_of_light) {
  Scene scene = knot_scene();
  scene.view.lights = {PointLight{{-1.5, -3, 3.5}, {{1, 0.5, 0.2}, 0.7}, {1, 0.1, 0.02}},
                       DirectionalLight{{0.3, 0.5, -1}, {{0.2, 1, 0.4}, 0.5}},
                       SpotLight{{2, -2, 2}, {-2, 2, -2}, 10, 40, {{1, 1, 1}, 0.6}, {}}};
  scene.view.material.highlights = Highlights::kGated;
  expect_close(scene);
}

TEST(Fast, draws_light_of_vertices) {
  Scene scene = knot_scene();
  scene.view.material.rate = ShadingFrequency::kVertex;
  expect_close(scene);
}

TEST(Fast, draws_textures_that_are_no_bytes_and_plain_colours) {
  Scene scene = knot_scene();
  scene.texture = testing::noise_texture(7, 5, 0.3337f);
  expect_close(scene);
  scene.texture = Vec3d{0.2, 0.6, 0.9};
  expect_close(scene);
}

TEST(Fast, draws_one_texel_and_a_texture_repeated_many_times) {
  Scene scene = knot_scene();
  scene.texture = testing::noise_texture(1, 1);
  expect_close(scene);
  scene = knot_scene();
  scene.texture = testing::noise_texture(3, 2);
  for (Vec2d& uv : scene.mesh.uvs) uv = {uv.u * 9 - 4, uv.v * 3 - 1};
  expect_close(scene);
}

// At 40,000 tiles neighbouring floats are a sixteenth of a texel apart.
TEST(Fast, draws_a_texture_scrolled_by_many_tiles) {
  Scene scene = knot_scene();
  for (Vec2d& uv : scene.mesh.uvs) uv = {uv.u * 2 + 40000, uv.v - 40000};
  expect_close(scene);
  scene.view.material.rate = ShadingFrequency::kVertex;
  expect_close(scene);
}

// Each ring of triangles begins in another tile.
TEST(Fast, draws_a_texture_repeated_from_triangle_to_triangle) {
  Scene scene = knot_scene();
  scene.texture = testing::noise_texture(4, 4);
  for (Vec2d& uv : scene.mesh.uvs) uv = {uv.u * 96 * 3, uv.v * 6};
  expect_close(scene);
}

// Image sizes that are multiples of neither tiles nor blocks.
TEST(Fast, draws_images_of_any_size) {
  for (const auto& [width, height] : {std::pair{1, 1}, {63, 65}, {130, 3}, {5, 200}}) {
    Scene scene = knot_scene();
    scene.view.image = {width, height, 1};
    const Difference d = difference(render(scene), fast_image(scene));
    EXPECT_LE(d.coverage, 2);
    EXPECT_LE(d.max, 1.0 / 255);
  }
}

TEST(Fast, clamps_a_texture_where_it_should) {
  Scene scene{testing::square(1), testing::noise_texture(4, 4), {}};
  for (Vec2d& uv : scene.mesh.uvs) uv = {uv.u * 3 - 1, uv.v * 3 - 1};  // the middle third
  scene.view.camera = testing::axis_camera(2, 60);
  scene.view.image = {60, 60, 1};
  scene.view.ambient = 1;
  scene.view.lights.clear();
  Options options;
  options.wrapping = Wrapping::kClamp;
  const Image image = fast_image(scene, options);
  const auto& texture = std::get<TextureImage>(scene.texture);
  // Ambient light only shows the texture; its corner texels in the corners.
  EXPECT_NEAR(image.at(5, 5).color.r, texture.at(0, 0).r, 1e-6);
  EXPECT_NEAR(image.at(54, 54).color.g, texture.at(3, 3).g, 1e-6);
}

// For a plane seen at a slant the reference's supersampled picture is the truth. It is isotropic,
// and so blurs what a slant does not.
TEST(Fast, trilinear_filtering_is_nearer_to_the_filtered_truth_than_bilinear) {
  Scene scene{testing::square(8), testing::noise_texture(256, 256), {}};
  scene.view.camera = {.position = {0, -9, 5}, .target = {0, 0, 0}, .fov_degrees = 50};
  scene.view.image = {64, 64, 1};
  scene.view.ambient = 1;
  scene.view.lights.clear();
  Scene fine = scene;
  fine.view.image.samples = 16;
  const Image truth = render(fine);
  Options options;
  const double bilinear = difference(truth, fast_image(scene, options)).mean;
  options.filter = Filter::kTrilinear;
  EXPECT_LT(difference(truth, fast_image(scene, options)).mean, bilinear / 2);
}

TEST(Fast, trilinear_filtering_of_a_magnified_texture_is_bilinear) {
  Scene scene = knot_scene();
  scene.texture = testing::noise_texture(2, 2);
  Options options;
  options.filter = Filter::kTrilinear;
  const Difference d = difference(fast_image(scene), fast_image(scene, options));
  EXPECT_LT(d.mean, 0.01);  // except for pixels at grazing angles
}

TEST(Fast, bytes_are_the_floats_rounded) {
  const Scene scene = knot_scene();
  Renderer renderer(scene, {});
  Image floats;
  Grid<Rgba8> bytes;
  renderer.draw(floats);
  renderer.draw(bytes);
  const auto byte_of = [](float x) { return int(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
  for (std::size_t i = 0; i < bytes.pixels.size(); ++i) {
    const RgbaPixel& p = floats.pixels[i];
    ASSERT_NEAR(bytes.pixels[i].r, byte_of(p.color.r), 0) << i;
    ASSERT_NEAR(bytes.pixels[i].g, byte_of(p.color.g), 0) << i;
    ASSERT_NEAR(bytes.pixels[i].b, byte_of(p.color.b), 0) << i;
    ASSERT_EQ(bytes.pixels[i].a, p.coverage > 0 ? 255 : 0) << i;
  }
}

}  // namespace
}  // namespace lumaknot::fast
