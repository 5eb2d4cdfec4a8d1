// What a recorded shot reads and how it names its steps: as much as its scene needs, and no more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scene/presets.h"
#include "shaders/graph/record.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/languages/every_shot.h"

namespace lumaknot {
namespace {

using testing::Contains;
using testing::IsSupersetOf;
using testing::Not;
using Names = std::multiset<std::string>;

std::vector<NodePtr> roots_of(const Recorded& recorded) {
  std::vector<NodePtr> roots{recorded.color};
  for (const Varying& varying : recorded.varyings) roots.push_back(varying.value);
  return roots;
}

Names names(const Recorded& recorded) {
  Names result;
  const std::vector<NodePtr> roots = roots_of(recorded);
  for (const Node* node : in_order(roots)) {
    if (!node->name.empty()) result.insert(node->name);
  }
  return result;
}

/// The names of what is read: inputs and parameters.
Names read_names(const Recorded& recorded) {
  Names result;
  const std::vector<NodePtr> roots = roots_of(recorded);
  for (const Node* node : in_order(roots)) {
    if (node->op == Op::kInput || node->op == Op::kParameter) result.insert(node->name);
  }
  return result;
}

std::map<std::string, Vec3d> parameters(const Recorded& recorded) {
  std::map<std::string, Vec3d> values;
  const std::vector<NodePtr> roots = roots_of(recorded);
  for (const Node* node : in_order(roots)) {
    if (node->op == Op::kParameter) values[node->name] = node->value;
  }
  return values;
}

bool has_operation(const Recorded& recorded, Op op) {
  const std::vector<NodePtr> roots = roots_of(recorded);
  for (const Node* node : in_order(roots)) {
    if (node->op == op) return true;
  }
  return false;
}

Shot shot_of(std::string_view formula, Stage stage = Stage::kFinal) {
  return {"s", stage, *with_formula(Material{}, formula)};
}

TEST(RecordNames, of_yiq_are_the_paper_s_once_each) {
  EXPECT_EQ(names(record_shot(View{}, shot_of("yiq-eq6"))),
            (Names{"position", "normal", "texture",                                // inputs
                   "eye_position", "light_position", "ambient", "shininess",       // parameters
                   "to_eye", "to_light", "n", "n_dot_l", "reflection", "r_dot_v",  // eq. 1, 2
                   "light", "highlight", "y", "i", "q", "lit_brightness"}));       // eq. 4, 6
}

TEST(RecordNames, of_every_model_tell_its_terms) {
  const auto of = [](const char* formula) { return names(record_shot(View{}, shot_of(formula))); };
  EXPECT_THAT(of("rgb-blinn-phong"), IsSupersetOf({"half_way", "n_dot_h"}));
  EXPECT_THAT(of("rgb-minnaert"), IsSupersetOf({"r_dot_v", "n_dot_l"}));
  EXPECT_THAT(of("rgb-oren-nayar"), IsSupersetOf({"variance", "n_dot_v", "across", "roughness"}));
  EXPECT_THAT(of("rgb-cook-torrance"),
              IsSupersetOf({"alpha", "half_way", "n_dot_h", "roughness", "reflectance"}));
  EXPECT_THAT(of("rgb-cook-torrance"), Not(Contains("shininess")));
}

TEST(RecordNames, the_texture_stage_is_one_node) {
  const Recorded recorded = record_shot(View{}, shot_of("phong", Stage::kTexture));
  EXPECT_EQ(in_order({recorded.color}).size(), 1u);
  EXPECT_EQ(recorded.color->op, Op::kInput);
  EXPECT_EQ(recorded.color->name, "texture");
}

TEST(RecordNames, the_diffuse_stage_needs_light_position_and_normal_alone) {
  EXPECT_EQ(names(record_shot(View{}, shot_of("phong", Stage::kDiffuse))),
            (Names{"position", "normal", "light_position", "to_light", "n", "n_dot_l"}));
}

TEST(RecordNames, the_specular_stage_needs_neither_texture_nor_weights) {
  EXPECT_EQ(read_names(record_shot(View{}, shot_of("phong", Stage::kSpecular))),
            (Names{"position", "normal", "eye_position", "light_position", "shininess"}));
}

TEST(RecordNames, phong_needs_no_luma) {
  const Names found = names(record_shot(View{}, shot_of("phong")));
  for (const char* name : {"y", "i", "q", "lit_brightness", "luma_offset"}) {
    EXPECT_THAT(found, Not(Contains(name)));
  }
}

TEST(RecordNames, the_collapsed_form_needs_no_chroma) {
  const Recorded recorded = record_shot(View{}, shot_of("yiq-collapsed-phong"));
  EXPECT_THAT(names(recorded), Not(Contains("i")));
  EXPECT_THAT(names(recorded), Not(Contains("q")));
  const auto steps = [](const Recorded& r) { return in_order({r.color}).size(); };
  EXPECT_LT(steps(recorded) + 5, steps(record_shot(View{}, shot_of("yiq-eq6"))));
}

TEST(RecordNames, the_baked_form_reads_axes_and_no_matrix_into_the_space) {
  const Recorded baked = record_shot(View{}, shot_of("yiq-baked-phong"));
  EXPECT_THAT(read_names(baked), Contains("texture_axes").Times(1));
  EXPECT_THAT(read_names(baked), Not(Contains("texture")));
  EXPECT_THAT(names(baked), Not(Contains("y")));
}

TEST(RecordNames, without_highlights_nothing_of_them_is_left) {
  for (const std::string& formula : formula_names()) {
    Shot shot = shot_of(formula);
    shot.material.specular = 0;
    shot.material.luma_offset = 0;
    shot.material.parameters["darkness"] = 1.5;
    // Minnaert's and Oren and Nayar's diffuse terms need the eye.
    const bool sees = formula.ends_with("minnaert") || formula.ends_with("oren-nayar");
    const Names found = read_names(record_shot(View{}, shot));
    for (const char* name : {"specular", "shininess", "reflectance", "emissive"}) {
      EXPECT_THAT(found, Not(Contains(name))) << formula;
    }
    EXPECT_EQ(found.contains("eye_position"), sees) << formula;
  }
}

TEST(RecordNames, figure_1_s_highlights_alone_need_no_diffuse_code) {
  const View view = builtin_scene("figure1-specular")->view;
  for (const char* formula : {"phong", "yiq-eq6", "yiq-collapsed-phong"}) {
    Shot shot = shot_of(formula);
    shot.material.diffuse = view.material.diffuse;
    const Names found = names(record_shot(view, shot));
    for (const char* name : {"diffuse", "ambient", "light"}) {
      EXPECT_THAT(found, Not(Contains(name))) << formula;
    }
    EXPECT_THAT(found, IsSupersetOf({"shininess", "r_dot_v"})) << formula;
  }
  // Eq. 3 without L_A and L_D is the highlight: no texture either.
  Shot phong = shot_of("phong");
  phong.material.diffuse = 0;
  EXPECT_THAT(names(record_shot(view, phong)), Not(Contains("texture")));
}

TEST(RecordNames, a_plain_white_light_leaves_neither_colour_nor_falloff) {
  for (const std::string& formula : formula_names()) {
    const Names found = read_names(record_shot(View{}, shot_of(formula)));
    for (const char* name : {"light_color", "light_constant", "light_linear", "light_quadratic",
                             "light_direction", "light_cos_outer", "diffuse", "specular"}) {
      EXPECT_THAT(found, Not(Contains(name))) << formula;
    }
  }
}

TEST(RecordNames, a_directional_light_needs_no_position) {
  View view;
  view.lights = {DirectionalLight{}};
  EXPECT_EQ(read_names(record_shot(view, shot_of("phong", Stage::kDiffuse))),
            (Names{"normal", "light_direction"}));
}

TEST(RecordNames, a_dark_light_leaves_nothing) {
  View view;
  view.lights = {PointLight{{1, 2, 3}, {{1, 1, 1}, 0}, {}}};
  EXPECT_EQ(read_names(record_shot(view, shot_of("phong"))), (Names{"texture", "ambient"}));
  view.lights = {};
  EXPECT_EQ(read_names(record_shot(view, shot_of("phong"))), (Names{"texture", "ambient"}));
}

TEST(RecordNames, minnaert_of_darkness_one_takes_no_power) {
  Shot shot = shot_of("rgb-minnaert", Stage::kDiffuse);
  EXPECT_FALSE(has_operation(record_shot(View{}, shot), Op::kPower));
  shot.material.parameters["darkness"] = 1.5;
  EXPECT_TRUE(has_operation(record_shot(View{}, shot), Op::kPower));
}

TEST(RecordNames, a_smooth_oren_nayar_surface_is_lambert) {
  Shot shot = shot_of("rgb-oren-nayar", Stage::kDiffuse);
  shot.material.parameters["roughness"] = 0;
  EXPECT_EQ(names(record_shot(View{}, shot)),
            names(record_shot(View{}, shot_of("phong", Stage::kDiffuse))));
}

TEST(RecordNames, only_gated_highlights_make_a_choice) {
  Shot shot = shot_of("phong");
  EXPECT_FALSE(has_operation(record_shot(View{}, shot), Op::kSelectLess));
  shot.material.highlights = Highlights::kGated;
  EXPECT_TRUE(has_operation(record_shot(View{}, shot), Op::kSelectLess));
}

TEST(RecordNames, an_interpolated_normal_is_not_made_unit) {
  Shot shot = shot_of("phong");
  shot.material.normal = NormalUse::kInterpolated;
  const Recorded recorded = record_shot(View{}, shot);
  for (const Node* node : in_order({recorded.color})) {
    if (node->op != Op::kUnit) continue;
    EXPECT_NE(node->arguments[0]->name, "normal");
  }
  EXPECT_THAT(names(recorded), Not(Contains("n")));
}

TEST(RecordNames, with_keep_all_every_number_of_the_formula_is_a_parameter) {
  const Recorded all = record_shot(View{}, shot_of("phong"), Keep::kAll);
  EXPECT_EQ(read_names(all),
            (Names{"position", "normal", "texture", "eye_position", "light_position", "light_color",
                   "light_constant", "light_linear", "light_quadratic", "ambient", "diffuse",
                   "specular", "emissive", "shininess"}));
}

TEST(RecordNames, parameters_hold_the_scene_s_numbers) {
  View view;
  view.camera.position = {3, -2, 4};
  view.lights = {SpotLight{{-2, -3, 3.5}, {0, 3, -4}, 60, 90, {{1, 0.5, 0.25}, 2}, {3, 4, 5}}};
  view.ambient = 0.3;
  Shot shot = shot_of("phong");
  shot.material.parameters["shininess"] = 17;
  shot.material.diffuse_color = {0.5, 0.5, 0.5};
  const auto values = parameters(record_shot(view, shot));
  EXPECT_EQ(values.at("eye_position"), (Vec3d{3, -2, 4}));
  EXPECT_EQ(values.at("light_position"), (Vec3d{-2, -3, 3.5}));
  EXPECT_EQ(values.at("light_direction"), (Vec3d{0, 0.6, -0.8}));
  EXPECT_EQ(values.at("light_color"), (Vec3d{2, 1, 0.5}));
  EXPECT_EQ(values.at("light_constant").x, 3);
  EXPECT_EQ(values.at("light_linear").x, 4);
  EXPECT_EQ(values.at("light_quadratic").x, 5);
  EXPECT_NEAR(values.at("light_cone_scale").x, 2, 1e-15);  // 1 / (cos 60 - cos 90)
  EXPECT_EQ(values.at("ambient").x, 0.3);
  EXPECT_EQ(values.at("diffuse").x, 0.5);
  EXPECT_EQ(values.at("shininess").x, 17);
}

TEST(RecordNames, several_lights_are_numbered) {
  const Names found = read_names(record_shot(every_view().back().view, shot_of("yiq-eq6")));
  EXPECT_THAT(found, IsSupersetOf({"light1_position", "light2_position", "light2_color",
                                   "light3_direction", "light4_cos_outer"}));
  EXPECT_THAT(found, Not(Contains("light_position")));
}

TEST(RecordNames, a_colour_without_texture_is_a_parameter) {
  const Vec3d color{0.2, 0.4, 0.6};
  const Recorded plain = record_shot(View{}, shot_of("yiq-eq6"), Keep::kNeeded, color);
  EXPECT_THAT(read_names(plain), Not(Contains("texture")));
  EXPECT_EQ(parameters(plain).at("base_color"), color);
  const Recorded baked = record_shot(View{}, shot_of("yiq-baked-phong"), Keep::kNeeded, color);
  EXPECT_EQ(parameters(baked).at("base_axes"),
            texture_value(color, *with_formula(Material{}, "yiq-baked-phong")));
}

TEST(RecordNames, light_at_vertices_is_in_the_varyings_alone) {
  Shot shot = shot_of("yiq-eq6");
  shot.material.rate = ShadingFrequency::kVertex;
  const Recorded recorded = record_shot(View{}, shot);
  ASSERT_EQ(recorded.varyings.size(), 2u);
  EXPECT_EQ(recorded.varyings[0].name, "diffuse_light");
  EXPECT_EQ(recorded.varyings[1].name, "specular_light");
  EXPECT_FALSE(recorded.varyings[0].value->is_vector);  // white light is one number
  EXPECT_EQ(read_names({{}, recorded.color}),
            (Names{"texture", "ambient", "diffuse_light", "specular_light"}));
}

TEST(RecordNames, a_varying_that_nothing_reads_is_left_out) {
  Shot shot = shot_of("phong");
  shot.material.rate = ShadingFrequency::kVertex;
  shot.material.specular = 0;
  EXPECT_EQ(record_shot(View{}, shot).varyings.size(), 1u);
  shot.stage = Stage::kTexture;
  EXPECT_TRUE(record_shot(View{}, shot).varyings.empty());
}

TEST(RecordNames, a_coloured_light_is_interpolated_as_a_vector_in_rgb_alone) {
  View view;
  view.lights = {PointLight{{1, 2, 3}, {{1, 0.5, 0.25}, 1}, {}}};
  for (const auto& [formula, vector] : {std::pair{"phong", true}, {"yiq-eq6", false}}) {
    Shot shot = shot_of(formula);
    shot.material.rate = ShadingFrequency::kVertex;
    for (const Varying& varying : record_shot(view, shot).varyings) {
      EXPECT_EQ(varying.value->is_vector, vector) << formula;
    }
  }
}

}  // namespace
}  // namespace lumaknot
