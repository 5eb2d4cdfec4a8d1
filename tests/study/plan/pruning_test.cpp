#include "study/plan/pruning.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/study/plan/testing.h"

namespace lumaknot::plan {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kShare = 1.0 / 255 / 4;

std::vector<std::string> names_of(const std::vector<Attempt>& all) {
  std::vector<std::string> names;
  for (const Attempt& t : all) names.push_back(t.what);
  return names;
}

Pruning dropped_of(const SceneSpec& spec, double share = kShare) {
  return drop(made(spec), seen_of(spec), share);
}

const SpotLight kWide{{-1.5, -3, 3.5}, {1.5, 3, -3.5}, 60, 80, {}, {}};

TEST(Pruning, a_scene_that_needs_all_loses_nothing) {
  const Pruning d = dropped_of(small_spec());
  EXPECT_THAT(names_of(d.dropped), IsEmpty());
  EXPECT_THAT(names_of(d.kept), Contains("light 1 left out"));
  EXPECT_EQ(d.change, 0);
}

TEST(Pruning, leaves_out_lights_too_weak_or_too_far_and_keeps_the_others) {
  SceneSpec spec = small_spec();
  spec.view.lights = {PointLight{.position = {30, 40, 20}, .color = {}, .falloff = {1, 0, 1}},
                      PointLight{}, DirectionalLight{{0, 0, -1}, {{1, 1, 1}, 1e-4}}};
  const Pruning d = dropped_of(spec);
  EXPECT_THAT(names_of(d.dropped), Contains("light 1 left out"));
  EXPECT_THAT(names_of(d.dropped), Contains("light 3 left out"));
  EXPECT_THAT(d.simplified.lights, ::testing::ElementsAre(2));
  EXPECT_GT(d.change, 0);
  EXPECT_LE(d.change, kShare);
}

TEST(Pruning, many_small_things_together_stay_within_the_share) {
  SceneSpec spec = small_spec();
  for (int i = 0; i < 9; ++i) {  // each 3e-4 of white on a colour of 0.8
    spec.view.lights.push_back(DirectionalLight{{0, 1, -1}, {{1, 1, 1}, 3e-4}});
  }
  const Pruning d = dropped_of(spec);
  EXPECT_LE(d.change, kShare);
  EXPECT_GT(d.dropped.size(), 0u);
  EXPECT_GT(d.simplified.lights.size(), 2u);  // all nine are beyond it
}

TEST(Pruning, terms_and_rules_without_effect_go) {
  SceneSpec spec = small_spec();
  Material& m = spec.view.material;
  m.model = Model::kCookTorrance;
  m.specular = 1e-7;
  m.emissive = {1e-5, 0, 0};
  m.gamut = Gamut::kClamp;
  m.highlights = Highlights::kGated;
  const Pruning d = dropped_of(spec);
  EXPECT_THAT(names_of(d.dropped), Contains("highlights left out"));
  EXPECT_THAT(names_of(d.dropped), Contains("emission left out"));
  EXPECT_THAT(names_of(d.dropped), Contains("gamut rule clamp left out"));
  EXPECT_THAT(names_of(d.dropped), Contains("gate of highlights left out"));
  EXPECT_THAT(names_of(d.dropped), Contains("cook-torrance as phong"));
  EXPECT_EQ(d.simplified.view.material.model, Model::kPhong);
}

TEST(Pruning, a_spot_whose_cone_holds_all_is_a_point_light) {
  SceneSpec spec = small_spec();
  spec.view.lights = {kWide};
  EXPECT_THAT(names_of(dropped_of(spec).dropped), Contains("light 1: spot as point"));
  SpotLight narrow = kWide;
  narrow.inner_degrees = 5, narrow.outer_degrees = 10;
  spec.view.lights = {narrow};
  EXPECT_THAT(names_of(dropped_of(spec).dropped), Not(Contains("light 1: spot as point")));
}

TEST(Pruning, a_lamp_that_is_very_far_is_directional) {
  SceneSpec spec = small_spec();
  spec.view.lights = {
      PointLight{.position = {-3e5, -6e5, 7e5}, .color = {}, .falloff = {0.5, 0, 0}}};
  const Pruning d = dropped_of(spec);
  EXPECT_THAT(names_of(d.dropped), Contains("light 1: point as directional"));
}

TEST(Pruning, a_texture_of_one_colour_is_that_colour) {
  SceneSpec spec = small_spec();
  Scene scene = made(spec);
  TextureImage image(4, 4);
  for (Rgb& c : image.pixels) c = {0.25f, 0.5f, 0.75f};
  scene.texture = image;
  const Pruning d = drop(scene, seen_of(spec), kShare);
  ASSERT_TRUE(std::holds_alternative<Vec3d>(d.simplified.texture));
  EXPECT_NEAR(std::get<Vec3d>(d.simplified.texture).y, 0.5, 1e-12);
}

TEST(Pruning, brightness_alone_on_a_grey_surface_is_light_on_every_channel) {
  SceneSpec spec = small_spec();
  spec.texture = PlainColor{{0.5, 0.5, 0.5}};
  spec.view.material.space = Space::kCielab;
  EXPECT_NE(dropped_of(spec).simplified.view.material.space, Space::kRgb);  // CIELAB is not linear
  spec.view.material.space = Space::kYiq;
  EXPECT_EQ(dropped_of(spec).simplified.view.material.space, Space::kRgb);
}

TEST(Pruning, coloured_light_on_brightness_alone_is_white) {
  SceneSpec spec = small_spec();
  spec.view.material.space = Space::kYiq;
  spec.view.ambient_color = {0.9, 0.5, 0.2};
  spec.view.material.ambient_color = {0.3, 0.6, 0.9};
  const Pruning d = dropped_of(spec);
  EXPECT_THAT(names_of(d.dropped), Contains("ambient colour as white"));
  EXPECT_LT(d.change, 1e-9);
}

/// A scene with everything in it.
SceneSpec full_spec(Model model, Space space) {
  SceneSpec spec = small_spec(48);
  spec.texture = Bricks{};
  spec.view.lights = {PointLight{.color = {{1, 0.8, 0.6}, 0.7}, .falloff = {0.5, 0.1, 0.02}}, kWide,
                      DirectionalLight{{0, 1, -1}, {{0.2, 0.5, 1}, 0.3}}};
  Material& m = spec.view.material;
  m.model = model;
  m.space = space;
  m.emissive = {0.02, 0.01, 0};
  m.diffuse_color = {1, 0.9, 0.8};
  m.specular_color = {0.5, 0.6, 0.7};
  m.luma_offset = space == Space::kRgb ? 0 : -0.05;
  m.highlights = Highlights::kGated;
  m.parameters["roughness"] = 0.7;
  m.parameters["darkness"] = 1.4;
  return spec;
}

TEST(Simplifications, change_no_colour_by_more_than_their_bound) {
  int bounded = 0;
  for (const Model model : {Model::kPhong, Model::kBlinnPhong, Model::kMinnaert, Model::kOrenNayar,
                            Model::kCookTorrance}) {
    for (const Space space : {Space::kRgb, Space::kYiq}) {
      const SceneSpec spec = full_spec(model, space);
      const Scene scene = made(spec);
      const std::vector<Fragment> seen = seen_of(spec);
      const Shot shot{"final", Stage::kFinal, scene.view.material};
      const Shading shading(scene, shot);
      for (const Simplification& s : simplifications(whole(scene), seen)) {
        if (!s.bound) continue;
        ++bounded;
        SimplifiedScene simplified = whole(scene);
        s.apply(simplified);
        const Scene changed{{}, simplified.texture, simplified.view};
        const Shot other{"final", Stage::kFinal, simplified.view.material};
        const Shading after(changed, other);
        double max = 0;
        for (const Fragment& point : seen) {
          const Vec3d d = after.color(point) - shading.color(point);
          max = std::max({max, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        }
        EXPECT_LE(max, *s.bound + 1e-12) << s.what << " " << int(model) << " " << int(space);
      }
    }
  }
  EXPECT_GT(bounded, 80);
}

}  // namespace
}  // namespace lumaknot::plan
