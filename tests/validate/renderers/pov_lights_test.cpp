// Lights, models and spaces in POV-Ray itself against our own image: it draws what its lighting can
// express; the rest is composed or skipped, with a note.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/shot.h"
#include "tests/validate/small_scene.h"
#include "validate/run.h"

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Material formula(std::string_view name) { return *with_formula(Material{}, name); }

Validation run(const Scene& scene, const std::vector<Shot>& finals) {
  return validate({scene, finals, {"povray"}, {}});
}

const Judged& judged(const Validation& v, std::string_view shot) {
  const auto found = std::ranges::find(v.shots, shot, &Shot::name);
  return v.results.at(0).shots.at(std::size_t(found - v.shots.begin()));
}

/// Every shot was drawn and agrees within POV-Ray's limits, classes explaining the outliers. All
/// other pixels agree to half a step of its 16-bit PNG, 8e-6, twice that where its texture is a
/// 16-bit luma, and a few times that where the terms are divided or a space enlarges them.
void expect_agreement(const Validation& v) {
  EXPECT_EQ(v.verdict, Verdict::kAgreed);
  for (std::size_t i = 0; i < v.shots.size(); ++i) {
    const Judged& shot = v.results.at(0).shots.at(i);
    EXPECT_EQ(shot.drawn.status, RenderedShot::Status::kDrawn) << v.shots[i].name << shot.drawn.why;
    EXPECT_THAT(shot.comparison.exceeded, IsEmpty()) << v.shots[i].name;
    EXPECT_GT(shot.comparison.inside, 1000) << v.shots[i].name;
    EXPECT_LT(shot.comparison.p9999_unclassed, 1e-4) << v.shots[i].name;
  }
}

void expect_native(const Validation& v) {
  expect_agreement(v);
  for (const Judged& shot : v.results.at(0).shots) EXPECT_EQ(shot.drawn.note, "");
}

/// The small scene in colours that would reveal a wrong channel.
Scene lit_by(std::vector<Light> lights) {
  Scene scene = testing::small_scene();
  scene.view.lights = std::move(lights);
  return scene;
}

std::vector<Shot> native_finals() {
  std::vector<Shot> finals;
  for (const char* name : {"rgb-phong", "rgb-blinn-phong", "yiq-phong", "yuv709-blinn-phong"}) {
    finals.push_back({name, Stage::kFinal, formula(name)});
  }
  return finals;
}

const PointLight kWarm{.position = {2.0, -2.5, 1.5}, .color = {{1, 0.7, 0.3}, 0.6}, .falloff = {}};

class PovLight : public ::testing::TestWithParam<std::pair<const char*, std::vector<Light>>> {};

TEST_P(PovLight, is_drawn_by_its_own_lighting) {
  expect_native(run(lit_by(GetParam().second), native_finals()));
}

SpotLight spot(Falloff falloff = {}) {
  return {.position = {-1.5, -3.0, 3.5},
          .direction = {1.5, 3.0, -3.5},
          .inner_degrees = 5,
          .outer_degrees = 20,  // the cone's edge lies across the knot
          .color = {{1, 0.9, 0.8}, 0.9},
          .falloff = falloff};
}

PointLight fading(Falloff falloff) {
  return {.position = {-0.5, -2.0, 1.5}, .color = {{1, 1, 1}, 1}, .falloff = falloff};
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, PovLight,
    ::testing::Values(
        std::pair{"none", std::vector<Light>{}},
        std::pair{"point", std::vector<Light>{PointLight{}}},
        std::pair{"colored_point", std::vector<Light>{kWarm}},
        std::pair{"directional",
                  std::vector<Light>{DirectionalLight{.direction = {1, 2, -1}, .color = {}}}},
        std::pair{"spot", std::vector<Light>{spot()}},
        std::pair{"fading_spot", std::vector<Light>{spot({1, 0, 0.1})}},
        std::pair{"widest_spot", std::vector<Light>{SpotLight{.position = {0.0, -1.2, 1.0},
                                                              .direction = {0, 0.2, -1},
                                                              .inner_degrees = 0,
                                                              .outer_degrees = 90,
                                                              .color = {},
                                                              .falloff = {}}}},
        std::pair{"linear_falloff", std::vector<Light>{fading({0.5, 0.4, 0})}},
        std::pair{"quadratic_falloff", std::vector<Light>{fading({0.5, 0, 0.4})}},
        std::pair{"falloff_without_constant", std::vector<Light>{fading({0, 0, 0.8})}},
        std::pair{"two",
                  std::vector<Light>{kWarm, DirectionalLight{.direction = {1, 2, -1},
                                                             .color = {{0.2, 0.5, 1}, 0.5}}}}),
    [](const auto& p) { return p.param.first; });

TEST(PovMaterial, colors_weights_and_what_it_sends_out_are_drawn_by_its_own_lighting) {
  Material rgb = formula("rgb-phong");
  rgb.ambient_color = {1, 0.5, 0.2};
  rgb.emissive = {0.1, 0, 0.2};
  Material tinted = rgb;  // the lights take the tint of the highlights
  tinted.diffuse_color = {0.9, 0.6, 0.3};
  tinted.specular_color = {1, 0.8, 0.1};
  Material luma = tinted;
  luma.space = Space::kYuv601;
  luma.luma_offset = -0.1;
  Scene scene = lit_by({kWarm});
  scene.view.ambient = 0.3;
  scene.view.ambient_color = {0.8, 1, 1};
  expect_native(run(scene, {{"rgb", Stage::kFinal, rgb},
                            {"tinted", Stage::kFinal, tinted},
                            {"luma", Stage::kFinal, luma}}));
  scene.texture = Vec3d{0.6, 0.4, 0.2};
  expect_native(run(scene, {{"tinted", Stage::kFinal, tinted}, {"luma", Stage::kFinal, luma}}));
}

TEST(PovMaterial, white_image_in_a_tint_stays_white) {
  // POV-Ray's functions begin again at 0 beyond 1, where interpolation may round a white.
  Scene scene = lit_by({PointLight{}});
  TextureImage white(7, 5);
  for (Rgb& texel : white.pixels) texel = {1, 1, 1};
  scene.texture = white;
  Material tinted = formula("rgb-phong");
  tinted.diffuse_color = {0.9, 0.6, 0.3};
  expect_native(run(scene, {{"tinted", Stage::kFinal, tinted}}));
}

TEST(PovMaterial, gated_highlights_need_no_class) {
  Material gated = formula("rgb-blinn-phong");
  gated.highlights = Highlights::kGated;
  gated.parameters["shininess"] = 4;
  Scene scene = lit_by({PointLight{.position = {-1, 2, 3}, .color = {}, .falloff = {}}});
  const Validation v = run(scene, {{"gated", Stage::kFinal, gated}});
  expect_native(v);
  const auto& classes = judged(v, "gated").comparison.classes;
  EXPECT_EQ(classes[std::size_t(PixelClass::kGatedHighlight)], 0);
}

TEST(PovMaterial, what_its_lighting_lacks_is_composed_from_its_terms) {
  std::vector<Shot> finals{{"rgb-phong", Stage::kFinal, formula("rgb-phong")}};
  for (const char* name :
       {"cielab-phong", "cieluv-blinn-phong", "din99-phong", "atd95-phong", "yiq-table1"}) {
    finals.push_back({name, Stage::kFinal, formula(name)});
  }
  finals.push_back({"chroma", Stage::kFinal, formula("rgb-phong")});
  finals.back().material.gamut = Gamut::kChroma;
  finals.push_back({"gated", Stage::kFinal, formula("cielab-blinn-phong")});
  finals.back().material.highlights = Highlights::kGated;
  finals.back().material.parameters["shininess"] = 3;
  finals.push_back({"gold", Stage::kFinal, formula("rgb-phong")});
  finals.back().material.specular_color = {1, 0.5, 0};
  // Two coloured lights, together beyond white: what each space sees of them differs, and the terms
  // don't fit into [0, 1].
  const Validation v = run(lit_by({PointLight{}, kWarm}), finals);
  expect_agreement(v);
  for (const Shot& shot : finals) {
    const std::string& note = judged(v, shot.name).drawn.note;
    if (shot.name == "rgb-phong") {
      EXPECT_EQ(note, "");
    } else {
      EXPECT_THAT(note, HasSubstr("composed")) << shot.name;
    }
  }
}

TEST(PovMaterial, what_can_not_be_composed_is_skipped_with_the_nearest_thing) {
  std::vector<Shot> finals{{"rgb-phong", Stage::kFinal, formula("rgb-phong")},
                           {"metal", Stage::kFinal, formula("yiq-cook-torrance")},
                           {"gouraud", Stage::kFinal, formula("rgb-phong")}};
  finals.back().material.rate = ShadingFrequency::kVertex;
  const Validation v = run(lit_by({PointLight{}}), finals);
  EXPECT_EQ(v.verdict, Verdict::kAgreed);
  EXPECT_EQ(judged(v, "rgb-phong").drawn.status, RenderedShot::Status::kDrawn);
  for (const auto& [shot, nearest] : {std::pair{"metal", "material.model \"blinn-phong\""},
                                      std::pair{"gouraud", "material.rate \"pixel\""}}) {
    EXPECT_EQ(judged(v, shot).drawn.status, RenderedShot::Status::kSkipped) << shot;
    EXPECT_THAT(judged(v, shot).drawn.why, HasSubstr(nearest));
  }
}

// POV-Ray names the file of a single frame as if there were no animation.
TEST(PovMaterial, one_frame_alone_is_drawn) {
  Shot shot{"gouraud", Stage::kFinal, formula("rgb-phong")};
  shot.material.rate = ShadingFrequency::kVertex;
  const Validation v = run(testing::small_scene(), {shot});
  EXPECT_EQ(judged(v, "texture").drawn.status, RenderedShot::Status::kDrawn);
  for (const char* skipped : {"diffuse", "specular", "gouraud"}) {
    EXPECT_EQ(judged(v, skipped).drawn.status, RenderedShot::Status::kSkipped) << skipped;
  }
}

TEST(PovMaterial, light_too_bright_for_terms_in_16_bits_is_skipped_where_it_is_composed) {
  PointLight glaring = kWarm;
  glaring.color.intensity = 100;
  const Validation v =
      run(lit_by({glaring}), {{"rgb-phong", Stage::kFinal, formula("rgb-phong")},
                              {"cielab-phong", Stage::kFinal, formula("cielab-phong")}});
  EXPECT_EQ(judged(v, "rgb-phong").drawn.status, RenderedShot::Status::kDrawn);
  EXPECT_EQ(judged(v, "cielab-phong").drawn.status, RenderedShot::Status::kSkipped);
  EXPECT_THAT(judged(v, "cielab-phong").drawn.why, HasSubstr("intensity"));
}

}  // namespace
}  // namespace lumaknot::validate
