// Models, spaces, lights and rules in Cycles, Eevee and Cycles' OSL, against our own image.
#include <gmock/gmock.h>

#include "render/reference.h"
#include "tests/validate/small_scene.h"
#include "validate/compare/images.h"
#include "validate/renderers/entry.h"

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A renderer and what its errors inside may come to.
struct Case {
  const char* name;
  double mean, max;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Figure 2, small, with a light of each kind, coloured.
Scene scene_in_three_lights() {
  Scene scene = testing::small_scene();
  scene.view.lights = {
      PointLight{}, DirectionalLight{.direction = {0.5, 1, -0.6}, .color = {{0.4, 0.5, 0.9}, 0.5}},
      SpotLight{.position = {1.5, -2.5, 2.5},
                .direction = {-1.5, 2.5, -2.5},
                .inner_degrees = 8,
                .outer_degrees = 30,
                .color = {{1, 0.6, 0.3}, 0.8},
                .falloff = {0.5, 0.1, 0.05}}};
  scene.view.ambient_color = {0.8, 1, 0.9};
  return scene;
}

Shot shot_of(const std::string& formula) {
  Material material;
  material.diffuse_color = {0.9, 0.8, 0.7};
  material.specular_color = {1, 0.9, 0.8};
  material.emissive = {0.05, 0, 0.1};
  material.parameters["darkness"] = 1.4;
  material.parameters["roughness"] = 0.4;
  return {formula, Stage::kFinal, *with_formula(material, formula)};
}

Shot gamut_chroma(const std::string& formula) {
  Shot shot = shot_of(formula);
  shot.name += "-chroma";
  shot.material.gamut = Gamut::kChroma;
  return shot;
}

Shot gated_and_clamped(const std::string& formula) {
  Shot shot = shot_of(formula);
  shot.name += "-gated";
  shot.material.gamut = Gamut::kClamp;
  shot.material.highlights = Highlights::kGated;
  return shot;
}

Shot baked_in_yuv709() {
  Shot shot = shot_of("yuv709-phong");
  shot.name += "-baked";
  shot.material.form = Form::kBaked;
  return shot;
}

/// Each model, space, form, rule of gamut and of highlights at least once.
std::vector<Shot> shots_of_every_kind() {
  std::vector<Shot> shots;
  for (const char* formula :
       {"yiq-table1-phong", "rgb-minnaert", "rgb-oren-nayar", "rgb-cook-torrance",
        "yiq-collapsed-blinn-phong", "yiq-baked-phong", "yuv601-minnaert", "cielab-blinn-phong",
        "cieluv-phong", "din99-oren-nayar", "atd95-cook-torrance"}) {
    shots.push_back(shot_of(formula));
  }
  shots.push_back(baked_in_yuv709());
  shots.push_back(gamut_chroma("rgb-phong"));
  shots.push_back(gamut_chroma("cielab-phong"));
  shots.push_back(gated_and_clamped("yiq-blinn-phong"));
  return shots;
}

class RendererOfBlender : public ::testing::TestWithParam<Case> {
 protected:
  std::unique_ptr<Renderer> renderer_ = renderer_entry(GetParam().name).make({});

  void SetUp() override {
    const Availability here = renderer_->availability();
    if (!here.found && renderer_->name() == "OSL") GTEST_SKIP() << here.remedy;
    ASSERT_TRUE(here.found) << here.remedy;
  }

  /// Ours and theirs agree within the case's limits.
  void expect_agreement(const Scene& scene, const std::vector<Shot>& shots) {
    const Grid<Fragment> fragments = visible_fragments(scene);
    const Reference reference(scene, fragments);
    const Rendering rendering = renderer_->draw(scene, shots);
    ASSERT_EQ(rendering.shots.size(), shots.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
      const RenderedShot& drawn = rendering.shots[i];
      ASSERT_EQ(drawn.status, RenderedShot::Status::kDrawn) << shots[i].name << ": " << drawn.why;
      const Standard standard{
          .limited = rendering.limited,
          .promise = promise_of(renderer_entry(renderer_->name()), rendering.version)};
      const Comparison c = compare(reference, shots[i], shade_all(scene, shots[i], fragments),
                                   drawn.image, sensitivities(reference, shots[i]), standard);
      EXPECT_GT(c.inside, 1000) << shots[i].name;
      EXPECT_EQ(c.coverage_unexplained, 0) << shots[i].name;
      EXPECT_THAT(c.exceeded, IsEmpty()) << shots[i].name;
      EXPECT_LE(c.mean, GetParam().mean) << shots[i].name;
      EXPECT_LE(c.max, GetParam().max) << shots[i].name;
    }
  }
};

TEST_P(RendererOfBlender, draws_every_kind_of_formula_as_we_do) {
  expect_agreement(scene_in_three_lights(), shots_of_every_kind());
}

TEST_P(RendererOfBlender, draws_a_plain_color_with_its_negative_chroma_as_we_do) {
  Scene scene = scene_in_three_lights();
  scene.texture = Vec3d{0.1, 0.2, 0.9};
  const Shot texture{"texture", Stage::kTexture, shot_of("yiq-baked-phong").material};
  expect_agreement(scene, {texture, shot_of("yiq-baked-phong"), baked_in_yuv709()});
}

TEST_P(RendererOfBlender, draws_what_no_light_reaches_as_we_do) {
  Scene scene = scene_in_three_lights();
  scene.view.lights.clear();
  const Shot diffuse{"diffuse", Stage::kDiffuse, shot_of("rgb-phong").material};
  expect_agreement(scene, {diffuse, shot_of("rgb-phong"), shot_of("cielab-cook-torrance")});
}

TEST_P(RendererOfBlender, skips_light_at_vertices_with_its_reason_and_draws_the_others) {
  Shot vertex = shot_of("rgb-minnaert");
  vertex.material.rate = ShadingFrequency::kVertex;
  const Rendering rendering = renderer_->draw(
      scene_in_three_lights(), std::vector{shot_of("rgb-phong"), vertex, shot_of("yiq-phong")});
  ASSERT_EQ(rendering.shots.size(), 3u);
  EXPECT_EQ(rendering.shots[1].status, RenderedShot::Status::kSkipped);
  EXPECT_THAT(rendering.shots[1].why, HasSubstr("the nearest is rate \"pixel\""));
  for (const std::size_t i : {0u, 2u}) {
    EXPECT_EQ(rendering.shots[i].status, RenderedShot::Status::kDrawn) << rendering.shots[i].why;
  }
  EXPECT_EQ(renderer_->draw(scene_in_three_lights(), std::vector{vertex}).command.size(), 0u)
      << "nothing is left to run";
}

// Cycles finds a point of a triangle, 32 texels wide, to a few 1e-5 in float32: that is 1/1000
// texel. Texels of the bricks differ by up to 0.3, which light and space enlarge by up to 3. Most
// pixels lie on one brick: the mean is a twentieth of it. OSL's fast pow adds 1e-5 of the colour to
// that. Eevee snaps vertices to 1/256 pixel, which its limits account for.
INSTANTIATE_TEST_SUITE_P(All, RendererOfBlender,
                         ::testing::Values(Case{"Cycles", 5e-5, 1e-3}, Case{"OSL", 6e-5, 1e-3},
                                           Case{"Eevee", 5e-4, 2e-2}),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace lumaknot::validate
