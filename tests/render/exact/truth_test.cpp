#include "render/exact/truth.h"

#include <gmock/gmock.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>

#include "math/angle.h"
#include "meshgen/knot_mesh.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "shaders/formulas/lighting.h"
#include "system/error.h"
#include "tests/render/exact/oracle.h"
#include "tests/render/testing.h"

namespace lumaknot::exact {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Scene figure(const KnotSpec& knot, int size, const Texture& texture = bricks()) {
  Scene scene{knot_mesh(knot), texture, builtin_scene("figure2")->view};
  scene.view.image = {size, size, 1};
  return scene;
}

KnotSpec figure_knot() { return std::get<KnotSpec>(builtin_scene("figure2")->mesh); }

/// Bilinear between texel centres, repeating, v upwards.
Vec3x texel_blend(const TextureImage& image, Extended u, Extended v) {
  const Extended x = (u - std::floor(u)) * image.width - 0.5L;
  const Extended y = (1 - (v - std::floor(v))) * image.height - 0.5L;
  const auto texel = [&](Extended i, Extended j) {
    const int a = (int(i) + image.width) % image.width;
    return extended(to_vec(image.at(a, (int(j) + image.height) % image.height)));
  };
  const Extended i = std::floor(x), j = std::floor(y), a = x - i, b = y - j;
  return (texel(i, j) * (1 - a) + texel(i + 1, j) * a) * (1 - b) +
         (texel(i, j + 1) * (1 - a) + texel(i + 1, j + 1) * a) * b;
}

/// Every `step`th pixel of the truth, recomputed in extended precision from its hit on.
void expect_agrees_with_extended_precision(const KnotSpec& knot, const Material& material) {
  constexpr int kSize = 120, kStep = 23;
  Scene scene = figure(knot, kSize);
  scene.view.material = material;
  const Shot shot{"final", Stage::kFinal, exact_material(material)};
  const Lighting<Extended> lighting = lighting_of<Extended>(scene.view, shot.material);
  const std::vector<Curve> curves = components(knot);
  const Grid<ExactFragment> seen = exact_fragments(scene, knot);
  int compared = 0;
  for (int i = 0; i < kSize * kSize; i += kStep) {
    const ExactFragment& pixel = seen.pixels[std::size_t(i)];
    const Fragment& f = pixel.fragment;
    if (!f.covered()) continue;
    const Curve& curve = curves[std::size_t(f.triangle)];
    const Vec3d eye = scene.view.camera.position;
    const int column = i % kSize, row = i / kSize;
    const Ray ray{eye, world_ray(scene.view.camera, kSize, kSize, column + 0.5, row + 0.5)};
    const ExtendedHit hit =
        polished(curve, knot.tube_radius, ray, {f.depth, 0, pixel.t, f.position, f.normal});
    EXPECT_LT(length(plain(hit.position) - f.position), 1e-10);
    EXPECT_LT(length(plain(hit.normal) - f.normal), 1e-10);
    const ExtendedFrame frame = extended_frame(curve, hit.t);
    const Extended theta =
        std::atan2(dot(hit.normal, frame.binormal), dot(hit.normal, frame.normal));
    const Extended turns = theta / (2 * kPiX);
    const Extended u =
        knot.repeat_u * (knot.unwrap == Unwrap::kParameter ? hit.t / (2 * kPiX) : frame.share);
    const Extended v = knot.repeat_v * (turns < 0 ? turns + 1 : turns);
    EXPECT_NEAR(f.uv.u, double(u), 1e-10);
    EXPECT_NEAR(f.uv.v, double(v), 1e-10);
    const Vec3x texture = texel_blend(std::get<TextureImage>(scene.texture), u, v);
    const Vec3x expected =
        stage_color(SurfacePoint<Extended>{hit.position, hit.normal}, texture, lighting, shot);
    EXPECT_LT(length(plain(expected) - shade(scene, shot, f)), 1e-8);
    ++compared;
  }
  EXPECT_GT(compared, 80);
}

TEST(Truth, of_figure2_agrees_with_itself_in_extended_precision) {
  expect_agrees_with_extended_precision(figure_knot(), {});
}

TEST(Truth, of_a_link_by_arc_length_agrees_with_itself_in_extended_precision) {
  KnotSpec knot = figure_knot();
  knot.p = 4;
  knot.q = -2;
  knot.repeat_v = 3;
  knot.unwrap = Unwrap::kArcLength;
  Material material = *with_formula({}, "yiq-table1-phong");
  expect_agrees_with_extended_precision(knot, material);
}

/// Root mean square errors of a mesh where both see the same sheet of the surface, not at a slant.
struct MeshError {
  double position = 0, color = 0, uv = 0;
};

MeshError mesh_error(KnotSpec knot, int segments) {
  knot.segments = segments;
  knot.sides = segments / 4;
  const Scene scene = figure(knot, 96, Vec3d{0.8, 0.5, 0.3});
  const Grid<ExactFragment> exact = exact_fragments(scene, knot);
  const Grid<Fragment> seen = visible_fragments(scene);
  const Shot shot{"final", Stage::kFinal, exact_material(scene.view.material)};
  MeshError sum;
  int count = 0;
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    const Fragment &a = exact.pixels[i].fragment, &b = seen.pixels[i];
    if (!a.covered() || !b.covered()) continue;
    const Vec3d to_eye = normalize(scene.view.camera.position - a.position);
    if (dot(a.normal, to_eye) < 0.3 || dot(a.normal, normalize(b.normal)) < 0.9) continue;
    const double gap = length(a.position - b.position);
    const double shade_gap = length(shade(scene, shot, a) - shade(scene, shot, b));
    sum.position += gap * gap;
    sum.color += shade_gap * shade_gap;
    sum.uv = std::max(sum.uv, std::abs(std::remainder(a.uv.v - b.uv.v, knot.repeat_v)));
    ++count;
  }
  return {std::sqrt(sum.position / count), std::sqrt(sum.color / count), sum.uv};
}

// Chords err by the square of their length, and so do interpolated normals and coordinates. Between
// these grids the order of few samples is within 0.15 of 2.
TEST(Truth, is_what_finer_meshes_approach_at_order_two) {
  const MeshError coarse = mesh_error(figure_knot(), 192), fine = mesh_error(figure_knot(), 768);
  EXPECT_NEAR(std::log(coarse.position / fine.position) / std::log(4), 2, 0.15);
  EXPECT_NEAR(std::log(coarse.color / fine.color) / std::log(4), 2, 0.15);
  EXPECT_LT(fine.uv, 1e-3);
}

// All these frames are perpendicular to the centre line: the mesh approaches the tube and its
// texture.
TEST(Truth, has_the_texture_coordinates_of_each_frame_rule) {
  KnotSpec knot = figure_knot();
  for (const FrameRule rule :
       {FrameRule::kDoubleReflection, FrameRule::kFrenet, FrameRule::kFixedUp}) {
    knot.frames = rule;
    const MeshError error = mesh_error(knot, 768);
    EXPECT_LT(error.position, 1e-3);
    EXPECT_LT(error.uv, 2e-3);  // where rings turn most from one to the next; a half turn is 0.5
  }
}

/// A ring seen along its axis covers an annulus.
TEST(Truth, of_a_ring_covers_the_area_of_an_annulus) {
  KnotSpec knot;
  knot.p = 1;
  knot.q = 0;  // a circle of radius 1.4
  knot.tube_radius = 0.25;
  Scene scene{{}, Vec3d{1, 1, 1}, {}};
  scene.view.camera = axis_camera(4, 60);
  scene.view.image = {40, 40, 1};
  const TruthOptions options{TruthSampling::kArea, 1.0 / 256};
  const Truth truth = draw_truth(scene, knot, options);
  double covered = 0, error = 0, noise = 0;
  for (std::size_t i = 0; i < truth.image.pixels.size(); ++i) {
    covered += truth.image.pixels[i].coverage;
    error = std::max<double>(error, truth.error.pixels[i]);
    noise += truth.error.pixels[i] * truth.error.pixels[i];
  }
  EXPECT_LE(error, options.tolerance);
  const double middle = std::atan2(1.4, 4), spread = std::asin(0.25 / std::hypot(1.4, 4));
  const double focal = 20 / std::tan(kPi / 6);
  const double outer = focal * std::tan(middle + spread), inner = focal * std::tan(middle - spread);
  const double area = kPi * (outer * outer - inner * inner);
  // Pixels err either way: three standard deviations of their estimated errors' sum.
  EXPECT_NEAR(covered, area, 3 * std::sqrt(noise));
  EXPECT_LT(std::sqrt(noise), 0.1);
}

// 32 x 32 samples per pixel, which themselves err by about 32^-1.5 of an edge's contrast: 1/512 at
// an edge of the bricks. The estimate is not a bound: about one in a hundred pixels with hundreds
// of texels errs by several tolerances.
TEST(Truth, area_sampled_is_the_mean_of_many_point_samples) {
  constexpr int kSize = 16, kSamples = 32;
  const TruthOptions options{TruthSampling::kArea, 1.0 / 512};
  Scene scene = figure(figure_knot(), kSize);
  const Image area = render_truth(scene, figure_knot(), options);
  scene.view.image = {kSize * kSamples, kSize * kSamples, 1};
  const Image many = render_truth(scene, figure_knot());
  double squares = 0;
  int strays = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      Vec3d sum;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        sum = sum + to_vec(many.at(x * kSamples + s % kSamples, y * kSamples + s / kSamples).color);
      }
      const Vec3d gap = sum / double(kSamples * kSamples) - to_vec(area.at(x, y).color);
      squares += dot(gap, gap) / 3;
      strays += length(gap) > 3.0 / 512;
    }
  }
  EXPECT_LE(strays, kSize * kSize / 100);
  EXPECT_LT(std::sqrt(squares / (kSize * kSize)), 0.5 / 512);
}

TEST(Truth, is_the_same_to_the_bit_on_one_thread) {
  const Scene scene = figure(figure_knot(), 32);
  for (const TruthSampling sampling : {TruthSampling::kPoint, TruthSampling::kArea}) {
    const Image all = render_truth(scene, figure_knot(), {sampling, 1.0 / 64});
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const Image alone = render_truth(scene, figure_knot(), {sampling, 1.0 / 64});
    EXPECT_EQ(
        std::memcmp(all.pixels.data(), alone.pixels.data(), all.pixels.size() * sizeof(RgbaPixel)),
        0);
  }
}

TEST(Truth, of_a_light_a_vertex_is_that_of_a_light_a_pixel) {
  Scene scene = figure(figure_knot(), 24);
  const Image expected = render_truth(scene, figure_knot());
  scene.view.material.rate = ShadingFrequency::kVertex;
  const Image drawn = render_truth(scene, figure_knot());
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    EXPECT_EQ(drawn.pixels[i].color, expected.pixels[i].color);
  }
}

TEST(Truth, refuses_frames_that_make_no_round_tube) {
  EXPECT_THAT([] { ExactTube tube(knot_defaults(Convention::kThree)); },
              ThrowsMessage<Error>(HasSubstr("mesh.knot.frames \"three\" has no exact surface")));
}

}  // namespace
}  // namespace lumaknot::exact
