// The names of lighting formulas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scene/check.h"
#include "scene/json.h"
#include "scene/presets.h"

namespace lumaknot {
namespace {

/// A material in which no number is a default.
Material unusual_numbers() {
  Material m;
  m.parameters["shininess"] = 7;
  m.parameters["roughness"] = 0.6;
  m.parameters["reflectance"] = 0.5;
  m.parameters["darkness"] = 1.5;
  m.diffuse = 0.25;
  m.specular = 0.75;
  m.ambient_color = {0.1, 0.2, 0.3};
  m.diffuse_color = {0.4, 0.5, 0.6};
  m.specular_color = {0.7, 0.8, 0.9};
  m.emissive = {0.15, 0.25, 0.35};
  m.gamut = Gamut::kChroma;
  m.highlights = Highlights::kGated;
  m.rate = ShadingFrequency::kVertex;
  return m;
}

/// The material as in scene.json: every field in one text.
std::string text_of(const Material& material) {
  SceneSpec scene;
  scene.view.material = material;
  return scene_to_json(scene);
}

TEST(Formulas, are_five_models_in_eleven_uses_of_a_space) {
  const std::vector<std::string> names = formula_names();
  EXPECT_EQ(names.size(), 55u);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 55u);
}

TEST(Formulas, every_space_and_every_model_has_one) {
  const std::vector<std::string> names = formula_names();
  for (const std::string_view space : kSpaceNames) {
    for (const std::string_view model : kModelNames) {
      const std::string name = std::string(space) + "-" + std::string(model);
      ASSERT_THAT(names, testing::Contains(name));
      const Material m = *with_formula(Material{}, name);
      EXPECT_EQ(kSpaceNames[std::size_t(m.space)], space) << name;
      EXPECT_EQ(kModelNames[std::size_t(m.model)], model) << name;
      EXPECT_EQ(m.form, Form::kMatrices) << name;
    }
  }
}

TEST(Formulas, collapsed_and_baked_are_forms_of_yiq) {
  for (const std::string_view model : kModelNames) {
    const Material collapsed = *with_formula({}, "yiq-collapsed-" + std::string(model));
    const Material baked = *with_formula({}, "yiq-baked-" + std::string(model));
    EXPECT_EQ(collapsed.space, Space::kYiq);
    EXPECT_EQ(collapsed.form, Form::kCollapsed);
    EXPECT_EQ(baked.space, Space::kYiq);
    EXPECT_EQ(baked.form, Form::kBaked);
  }
}

TEST(Formulas, only_table_1_clamps_shifts_the_luma_and_leaves_the_normal) {
  for (const std::string& name : formula_names()) {
    const Material m = *with_formula(Material{}, name);
    const bool table1 = name.starts_with("yiq-table1-");
    EXPECT_EQ(m.clamp, table1 ? Clamp::kTable1 : Clamp::kFree) << name;
    EXPECT_EQ(m.normal, table1 ? NormalUse::kInterpolated : NormalUse::kUnit) << name;
    EXPECT_EQ(m.luma_offset, table1 ? -0.1 : 0) << name;
  }
}

TEST(Formulas, every_one_is_a_valid_material_and_reads_back) {
  for (const std::string& name : formula_names()) {
    SceneSpec scene;
    scene.view.material = *with_formula(Material{}, name);
    EXPECT_NO_THROW(check_scene(scene)) << name;
    const SceneSpec again = scene_from_json(scene_to_json(scene), "scene.json");
    EXPECT_EQ(formula_name(again.view.material), formula_name(scene.view.material)) << name;
  }
}

TEST(Formulas, a_formula_s_name_is_found_again_under_the_paper_s_where_it_has_one) {
  const std::map<std::string, std::string> short_names{
      {"rgb-phong", "phong"}, {"yiq-table1-phong", "yiq-table1"}, {"yiq-phong", "yiq-eq6"}};
  for (const std::string& name : formula_names()) {
    const auto found = short_names.find(name);
    EXPECT_EQ(formula_name(*with_formula(unusual_numbers(), name)),
              found == short_names.end() ? name : found->second);
  }
}

TEST(Formulas, the_paper_s_names_are_the_formulas_they_stand_for) {
  const std::vector<std::string> names = formula_names();
  for (const NamedMaterial& named : paper_materials()) {
    ASSERT_THAT(names, testing::Contains(std::string(named.formula)));
    EXPECT_EQ(text_of(*with_formula(unusual_numbers(), named.name)),
              text_of(*with_formula(unusual_numbers(), named.formula)));
    EXPECT_EQ(formula_name(*with_formula(Material{}, named.name)), named.name);
    EXPECT_FALSE(named.about.empty()) << named.name;
  }
}

TEST(Formulas, keep_the_surface_s_own_numbers_and_rules) {
  for (const std::string& name : formula_names()) {
    const Material base = unusual_numbers();
    Material m = *with_formula(base, name);
    // The fields that a formula sets; the rest must be the base's.
    m.model = base.model;
    m.space = base.space;
    m.form = base.form;
    m.luma_offset = base.luma_offset;
    m.clamp = base.clamp;
    m.normal = base.normal;
    EXPECT_EQ(text_of(m), text_of(base)) << name;
  }
}

TEST(Formulas, are_the_same_whatever_the_base_s_formula) {
  for (const char* from : {"yiq-table1", "yiq-baked-minnaert", "cielab-cook-torrance"}) {
    const Material base = *with_formula(unusual_numbers(), from);
    for (const std::string& name : formula_names()) {
      EXPECT_EQ(text_of(*with_formula(base, name)),
                text_of(*with_formula(unusual_numbers(), name)));
    }
  }
}

TEST(Formulas, any_other_is_custom) {
  for (const std::string& name : formula_names()) {
    const Material formula = *with_formula(Material{}, name);
    Material m = formula;
    m.clamp = m.clamp == Clamp::kFree ? Clamp::kTable1 : Clamp::kFree;
    EXPECT_EQ(formula_name(m), "custom") << name;
    m = formula;
    m.luma_offset += 0.5;
    EXPECT_EQ(formula_name(m), "custom") << name;
    m = formula;
    m.normal = m.normal == NormalUse::kUnit ? NormalUse::kInterpolated : NormalUse::kUnit;
    EXPECT_EQ(formula_name(m), "custom") << name;
  }
}

TEST(Formulas, an_unknown_name_is_nothing) {
  for (const char* name : {"", "yiq", "rgb", "phong-rgb", "rgb-collapsed-phong", "YIQ-phong",
                           "yiq-phong ", "cielab-baked-phong", "custom"}) {
    EXPECT_FALSE(with_formula(Material{}, name)) << name;
  }
}

}  // namespace
}  // namespace lumaknot
