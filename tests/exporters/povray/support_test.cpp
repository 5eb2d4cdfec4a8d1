#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/povray/scene.h"
#include "tests/exporters/povray/testing.h"

namespace lumaknot::povray {
namespace {

using ::testing::HasSubstr;
using testing::material;
using ::testing::Optional;

Shot final_shot(const Material& m) { return {"s", Stage::kFinal, m}; }

std::optional<std::string> shortfall(const Material& m) { return pov_shortfall({}, final_shot(m)); }
std::optional<std::string> missing(const Material& m) {
  return pov_missing_term({}, final_shot(m));
}

TEST(PovShortfall, rgb_and_linear_spaces_with_lambert_and_phong_or_blinn_have_none) {
  for (const char* space : {"rgb", "yiq", "yiq-collapsed", "yiq-baked", "yuv601", "yuv709"}) {
    for (const char* model : {"phong", "blinn-phong"}) {
      Material m = material(std::string(space) + "-" + model);
      EXPECT_EQ(shortfall(m), std::nullopt) << space << model;
      m.highlights = Highlights::kGated;
      m.gamut = Gamut::kClamp;
      m.emissive = {0.1, 0.2, 0.3};
      m.diffuse_color = {1, 0.5, 0};
      m.specular_color = {1, 0.5, 0.25};
      EXPECT_EQ(shortfall(m), std::nullopt) << space << model;
    }
  }
}

TEST(PovShortfall, only_a_final_shot_lacks_clamps_and_it_names_them) {
  const auto lack = [](Stage stage, Clamp clamp, NormalUse normal) {
    Material m;
    m.clamp = clamp;
    m.normal = normal;
    return pov_shortfall({}, {"s", stage, m});
  };
  using enum Stage;
  EXPECT_FALSE(lack(kFinal, Clamp::kFree, NormalUse::kUnit));
  EXPECT_FALSE(lack(kTexture, Clamp::kTable1, NormalUse::kInterpolated));
  EXPECT_EQ(lack(kFinal, Clamp::kTable1, NormalUse::kUnit),
            "POV-Ray can't clamp ambient plus diffuse light");
  EXPECT_EQ(lack(kFinal, Clamp::kFree, NormalUse::kInterpolated),
            "POV-Ray can't use an interpolated normal without renormalising it");
  EXPECT_EQ(lack(kFinal, Clamp::kTable1, NormalUse::kInterpolated),
            "POV-Ray can't clamp ambient plus diffuse light nor use an interpolated normal without "
            "renormalising it");
}

TEST(PovShortfall, rule_for_the_gamut_and_spaces_that_are_not_linear_leave_the_terms) {
  Material chroma;
  chroma.gamut = Gamut::kChroma;
  EXPECT_THAT(shortfall(chroma), Optional(HasSubstr("hue of colours beyond [0, 1]")));
  EXPECT_EQ(missing(chroma), std::nullopt);
  for (const char* space : {"cielab", "cieluv", "din99", "atd95"}) {
    const Material m = material(std::string(space) + "-phong");
    EXPECT_EQ(shortfall(m),
              std::string("POV-Ray can't light the brightness of ") + space + " alone");
    EXPECT_EQ(missing(m), std::nullopt);
  }
}

TEST(PovShortfall, models_lack_only_their_own_terms) {
  EXPECT_EQ(missing(material("rgb-minnaert")), std::nullopt) << "darkness 1 is Lambert";
  Material minnaert = material("rgb-minnaert");
  minnaert.parameters["darkness"] = 2;
  EXPECT_EQ(missing(minnaert),
            "POV-Ray can't draw Minnaert's diffuse term; nearest: material.darkness 1");
  EXPECT_EQ(shortfall(minnaert), "POV-Ray can't draw Minnaert's diffuse term");
  minnaert.diffuse = 0;
  EXPECT_EQ(missing(minnaert), std::nullopt);

  Material oren_nayar = material("yiq-oren-nayar");
  EXPECT_THAT(missing(oren_nayar), Optional(HasSubstr("material.roughness 0")));
  oren_nayar.parameters["roughness"] = 0;
  EXPECT_EQ(shortfall(oren_nayar), std::nullopt);

  Material metal = material("cielab-cook-torrance");
  EXPECT_THAT(missing(metal), Optional(HasSubstr("nearest: material.model \"blinn-phong\"")));
  EXPECT_EQ(pov_missing_term({}, {"s", Stage::kDiffuse, metal}), std::nullopt);
  EXPECT_NE(pov_missing_term({}, {"s", Stage::kSpecular, metal}), std::nullopt);
  metal.specular_color = {};
  EXPECT_EQ(missing(metal), std::nullopt);
}

TEST(PovShortfall, exponent_0_is_missing) {
  Material m;
  m.parameters["shininess"] = 0;
  EXPECT_THAT(missing(m), Optional(HasSubstr("exponent 0")));
}

TEST(PovShortfall, light_at_the_vertices_is_missing_where_there_is_light) {
  Material m;
  m.rate = ShadingFrequency::kVertex;
  EXPECT_EQ(missing(m), "POV-Ray can't compute light per vertex; nearest: material.rate \"pixel\"");
  EXPECT_EQ(pov_missing_term({}, {"s", Stage::kTexture, m}), std::nullopt);
  m.diffuse = m.specular = 0;
  EXPECT_EQ(missing(m), std::nullopt);
}

TEST(PovShortfall, lights_are_named_by_their_place_in_the_scene) {
  View view;
  view.lights = {DirectionalLight{}, PointLight{}, SpotLight{}};
  EXPECT_EQ(pov_shortfall(view, final_shot({})), std::nullopt);
  std::get<PointLight>(view.lights[1]).falloff = {1, 0.1, 0.1};
  std::get<SpotLight>(view.lights[2]).outer_degrees = 100;
  const auto lack = pov_missing_term(view, final_shot({}));
  EXPECT_THAT(lack, Optional(HasSubstr("lights[1].point.linear 0 or quadratic 0")));
  EXPECT_THAT(lack, Optional(HasSubstr("lights[2].spot.outer_degrees 90")));
  EXPECT_EQ(pov_missing_term(view, {"s", Stage::kTexture, {}}), std::nullopt);
}

TEST(PovShortfall, channel_without_highlights_needs_to_be_without_diffuse_light) {
  Material gold;
  gold.specular_color = {1, 0.5, 0};
  EXPECT_THAT(shortfall(gold), Optional(HasSubstr("channel without highlights")));
  EXPECT_EQ(missing(gold), std::nullopt);
  gold.diffuse_color = {0.3, 0.2, 0};
  EXPECT_EQ(shortfall(gold), std::nullopt);
  gold.diffuse_color = {0.3, 0.2, 0.1};
  gold.space = Space::kYiq;
  EXPECT_EQ(shortfall(gold), std::nullopt) << "only its brightness counts";
}

TEST(PovShortfall, export_refuses_what_would_be_another_formula_and_names_the_nearest) {
  const auto check = [](const Material& m) { check_pov_export({}, final_shot(m)); };
  Material chroma;
  chroma.gamut = Gamut::kChroma;
  EXPECT_NO_THROW(check(chroma));
  EXPECT_NO_THROW(check(material("yiq-table1")));
  EXPECT_EQ(error_of([&] { check(material("din99-cook-torrance")); }),
            "POV-Ray can't draw the highlights of Cook and Torrance nor light the brightness of "
            "din99 alone; nearest: material.model \"blinn-phong\", material.space \"yiq\"");
}

}  // namespace
}  // namespace lumaknot::povray
