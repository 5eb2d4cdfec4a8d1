// Images of formulas that must be one image: forms of a space, lights in several pieces.
#include <gtest/gtest.h>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "tests/render/testing.h"

namespace lumaknot {
namespace {

Scene knot_scene() {
  KnotSpec knot;
  knot.segments = 60;
  knot.sides = 12;
  knot.repeat_u = 12;
  Scene scene{knot_mesh(knot), bricks(), {}};
  scene.view.image = {48, 36, 1};
  return scene;
}

/// The largest difference of any pixel's colour, in double.
double largest_difference(const Scene& scene, const Material& a, const Material& b) {
  double largest = 0;
  int count = 0;
  for (const Fragment& f : visible_fragments(scene).pixels) {
    if (!f.covered()) continue;
    ++count;
    const Vec3d apart =
        shade(scene, {"a", Stage::kFinal, a}, f) - shade(scene, {"b", Stage::kFinal, b}, f);
    largest = std::max(largest, length(apart));
  }
  EXPECT_GT(count, 200);
  return largest;
}

Material with_form(const Material& base, Form form) {
  Material m = base;
  m.form = form;
  return m;
}

TEST(RenderForms, baked_equals_matrices) {
  const Scene scene = knot_scene();
  for (const Space space : {Space::kYiq, Space::kYuv601, Space::kYuv709}) {
    Material m;
    m.space = space;
    EXPECT_LT(largest_difference(scene, m, with_form(m, Form::kBaked)), 1e-12);  // rounding
  }
}

TEST(RenderForms, collapsed_equals_matrices) {
  const Scene scene = knot_scene();
  for (const Space space : {Space::kYiq, Space::kYuv601, Space::kYuv709}) {
    Material m;
    m.space = space;
    // The paper's M and W are inverse to 1e-7 as printed; exact inverses round.
    const double tolerance = space == Space::kYiq ? 1e-6 : 1e-12;
    EXPECT_LT(largest_difference(scene, m, with_form(m, Form::kCollapsed)), tolerance);
  }
}

TEST(RenderForms, of_the_texture_stage_show_the_texture) {
  const Scene scene = knot_scene();
  Material m;
  m.space = Space::kYiq;
  for (const Fragment& f : visible_fragments(scene).pixels) {
    const Vec3d plain = shade(scene, {"t", Stage::kTexture, m}, f);
    const Vec3d baked = shade(scene, {"t", Stage::kTexture, with_form(m, Form::kBaked)}, f);
    EXPECT_LT(length(plain - baked), 1e-6);  // there and back by M and W
  }
}

TEST(RenderFormulas, every_one_draws_a_finite_image_of_its_own) {
  const Scene scene = knot_scene();
  const Grid<Fragment> seen = visible_fragments(scene);
  std::vector<Image> images;
  for (const std::string& name : formula_names()) {
    const Material m = *with_formula(Material{}, name);
    images.push_back(shade_all(scene, {"final", Stage::kFinal, m}, seen));
    double sum = 0;
    for (const RgbaPixel& p : images.back().pixels) {
      ASSERT_TRUE(is_finite(to_vec(p.color))) << name;
      sum += length(to_vec(p.color));
    }
    EXPECT_GT(sum, 50) << name;
  }
}

TEST(RenderLights, one_light_of_two_is_two_of_half) {
  Scene one = knot_scene(), two = knot_scene();
  one.view.lights = {PointLight{{-1.5, -3, 3.5}, {{1, 0.8, 0.6}, 2}, {}}};
  const PointLight half{{-1.5, -3, 3.5}, {{1, 0.8, 0.6}, 1}, {}};
  two.view.lights = {half, half};
  const Image a = render(one), b = render(two);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    // Rounded to float: half a unit of 2^-23 for values up to 4.
    EXPECT_LT(length(to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color)), 1e-6);
  }
}

TEST(RenderLights, none_leave_the_ambient_light) {
  Scene scene = knot_scene();
  scene.view.lights = {};
  scene.view.ambient = 0.5;
  scene.texture = Vec3d{0.5, 0.25, 1};
  for (const RgbaPixel& p : render(scene).pixels) {
    EXPECT_EQ(p.color, p.coverage > 0 ? (Rgb{0.25f, 0.125f, 0.5f}) : Rgb{});
  }
}

TEST(Compose, our_own_stages_give_the_final_image_for_every_formula) {
  const Scene scene = knot_scene();
  const Grid<Fragment> seen = visible_fragments(scene);
  for (const std::string& name : formula_names()) {
    const Material m = *with_formula(Material{}, name);
    const auto stage = [&](Stage s) { return shade_all(scene, {"stage", s, m}, seen); };
    const Image composed = compose(scene, {"final", Stage::kFinal, m}, stage(Stage::kTexture),
                                   stage(Stage::kDiffuse), stage(Stage::kSpecular));
    const Image expected = stage(Stage::kFinal);
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
      const Vec3d a = to_vec(composed.pixels[i].color), b = to_vec(expected.pixels[i].color);
      // Each stage was rounded to float, 6e-8 of its value; the sRGB curve near black multiplies
      // by 13, a cone response of ATD95 by 30.
      EXPECT_LT(length(a - b), 2e-6 * std::max(1.0, length(b))) << name;
    }
  }
}

}  // namespace
}  // namespace lumaknot
