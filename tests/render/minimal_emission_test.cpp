// What a scene does not need is omitted from its shader (Keep::kNeeded), and no pixel changes: the
// shader's graph computes the picture that render() draws with every term written out.
#include <gtest/gtest.h>

#include <functional>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "render/texture.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "tests/shaders/graph/evaluate.h"

namespace lumaknot {
namespace {

Scene knot_scene() {
  KnotSpec knot;
  knot.segments = 60;
  knot.sides = 12;
  knot.repeat_u = 12;
  Scene scene{knot_mesh(knot), bricks(), {}};
  scene.view.image = {32, 24, 1};
  return scene;
}

struct Dropped {
  std::string what;
  std::function<void(Scene&)> apply;  ///< changes the scene so that it does not need the term
};

/// Every term that a scene can do without; the last leaves out all at once.
std::vector<Dropped> dropped_terms() {
  const auto material = [](auto member, auto value) {
    return [=](Scene& scene) { scene.view.material.*member = value; };
  };
  std::vector<Dropped> terms{
      {"specular", material(&Material::specular, 0.0)},
      {"diffuse", material(&Material::diffuse, 0.0)},
      {"offset", material(&Material::luma_offset, 0.0)},
      {"emissive", material(&Material::emissive, Vec3d{})},
      {"powers", [](Scene& s) { s.view.material.parameters["shininess"] = 1; }},
      {"exponent of Minnaert", [](Scene& s) { s.view.material.parameters["darkness"] = 1; }},
      {"ambient", [](Scene& scene) { scene.view.ambient = 0; }},
      {"falloff and the colour of light", [](Scene& s) { s.view.lights = {PointLight{}}; }},
      {"distance", [](Scene& s) { s.view.lights = {DirectionalLight{}}; }},
      {"light", [](Scene& scene) { scene.view.lights.clear(); }},
      {"texture", [](Scene& scene) { scene.texture = Vec3d{0.7, 0.5, 0.25}; }}};
  const std::vector<Dropped> some(terms.begin() + 2, terms.end() - 2);
  terms.push_back({"all of these", [some](Scene& scene) {
                     for (const Dropped& term : some) term.apply(scene);
                   }});
  return terms;
}

/// A scene whose numbers are neither 0 nor 1, so that it needs every term of `formula`.
Scene needing_all(const Scene& knot, const std::string& formula) {
  Scene scene = knot;
  const LightColor amber{{0.9, 0.6, 0.2}, 1.5};
  const Falloff falloff{0.25, 0.125, 0.0625};
  scene.view.lights = {PointLight{{2, -1, 3}, amber, falloff},
                       SpotLight{{-1.5, -3, 3.5}, {1.5, 3, -3.5}, 10, 40, amber, falloff}};
  scene.view.ambient_color = {0.6, 0.8, 0.9};
  Material m;
  m.diffuse = 0.75;
  m.specular = 0.5;
  m.parameters["darkness"] = 1.5;
  m.emissive = {0.02, 0.01, 0.03};
  scene.view.material = *with_formula(m, formula);
  if (scene.view.material.space != Space::kRgb) scene.view.material.luma_offset = -0.05;
  return scene;
}

int parameter_count(const Recorded& recorded) {
  int count = 0;
  for (const Node* node : in_order({recorded.color})) count += node->op == Op::kParameter;
  return count;
}

Recorded recorded_shot(const Scene& scene, Keep keep) {
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  const auto* color = std::get_if<Vec3d>(&scene.texture);
  return record_shot(scene.view, shot, keep, color ? std::optional(*color) : std::nullopt);
}

/// The picture that the minimal graph computes.
Image minimal_image(const Scene& scene, const Recorded& recorded) {
  const Grid<Fragment> fragments = visible_fragments(scene);
  Image image(fragments.width, fragments.height);
  for (std::size_t i = 0; i < fragments.pixels.size(); ++i) {
    const Fragment& f = fragments.pixels[i];
    if (!f.covered()) continue;
    const Vec3d texture = texture_color(scene.texture, f.uv);
    image.pixels[i] = {to_rgb(evaluate(recorded, surface_inputs({f.position, f.normal}, texture,
                                                                scene.view.material))),
                       1};
  }
  return image;
}

/// How many pixels of two images differ in any bit.
int different_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb &p = a.pixels[i].color, &q = b.pixels[i].color;
    count += !(p.r == q.r && p.g == q.g && p.b == q.b);
  }
  return count;
}

class MinimalEmission : public ::testing::TestWithParam<std::size_t> {};

TEST_P(MinimalEmission, leaves_a_term_out_and_changes_no_pixel) {
  const Dropped term = dropped_terms()[GetParam()];
  const Scene knot = knot_scene();
  for (const std::string& formula : formula_names()) {
    Scene scene = needing_all(knot, formula);
    term.apply(scene);
    const Recorded needed = recorded_shot(scene, Keep::kNeeded);
    EXPECT_EQ(different_pixels(minimal_image(scene, needed), render(scene)), 0)
        << formula << " without " << term.what;
    EXPECT_LE(parameter_count(needed), parameter_count(recorded_shot(scene, Keep::kAll)));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, MinimalEmission,
                         ::testing::Range(std::size_t{0}, dropped_terms().size()),
                         [](const auto& p) {
                           std::string name = dropped_terms()[p.param].what;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

TEST(MinimalEmission, is_smaller_where_a_term_is_not_needed) {
  const Scene all = needing_all(knot_scene(), "yiq-phong");
  const int full = parameter_count(recorded_shot(all, Keep::kNeeded));
  EXPECT_EQ(full, parameter_count(recorded_shot(all, Keep::kAll)));
  for (const Dropped& term : dropped_terms()) {
    if (term.what == "texture" || term.what == "exponent of Minnaert") continue;
    Scene scene = all;
    term.apply(scene);
    EXPECT_LT(parameter_count(recorded_shot(scene, Keep::kNeeded)), full) << term.what;
  }
}

}  // namespace
}  // namespace lumaknot
