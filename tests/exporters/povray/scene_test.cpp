#include "exporters/povray/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "math/angle.h"
#include "shaders/formulas/lighting.h"
#include "tests/exporters/povray/testing.h"

namespace lumaknot::povray {
namespace {

using testing::color_of;
using ::testing::ElementsAre;
using testing::expect_near;
using ::testing::HasSubstr;
using testing::kColor;
using testing::kNumber;
using testing::kVector;
using testing::Match;
using testing::matches;
using testing::material;
using ::testing::Not;
using testing::occurrences;
using testing::scene_text;
using testing::small_scene;
using testing::vector_of;

Vec3d camera_vector(const std::string& text, const std::string& name) {
  const auto found = matches(text, "\n  " + name + " " + kVector);
  return found.size() == 1 ? vector_of(found[0]) : throw std::runtime_error("no " + name);
}

TEST(PovScene, camera_vectors_are_orthogonal_right_handed_and_span_the_image) {
  Scene scene = small_scene();
  scene.view.camera = {
      .position = {1, -4, 2}, .target = {0.5, 0, 0.25}, .up = {0.2, 0, 1}, .fov_degrees = 50};
  scene.view.image = {300, 200, 1};
  const std::string text = scene_text(scene, Stage::kFinal, Material{});
  const Vec3d direction = camera_vector(text, "direction"), right = camera_vector(text, "right"),
              up = camera_vector(text, "up");
  constexpr double kRounding = 1e-14;  // numbers are printed so that they read back exactly
  EXPECT_EQ(camera_vector(text, "location"), scene.view.camera.position);
  EXPECT_NEAR(length(direction), 1, kRounding);
  EXPECT_NEAR(length(up), 2 * std::tan(25 * kPi / 180), kRounding);
  EXPECT_NEAR(length(right), 1.5 * length(up), kRounding);
  EXPECT_NEAR(dot(direction, right), 0, kRounding);
  EXPECT_NEAR(dot(direction, up), 0, kRounding);
  EXPECT_NEAR(dot(right, up), 0, kRounding);
  EXPECT_GT(dot(cross(right, up), -direction), 0);  // x right, y up, looking along -z
  EXPECT_GT(dot(up, scene.view.camera.up), 0);
  const Vec3d sight = normalize(scene.view.camera.target - scene.view.camera.position);
  EXPECT_NEAR(length(direction - sight), 0, kRounding);
}

/// A colour of POV-Ray's light and the share that reaches the eye, before the surface's weights.
struct PovLight {
  Vec3d color;
  double diffuse, specular;
};

/// The result of POV-Ray's documented lighting for the texture in `text`, whose pigments are plain:
/// the average of its members, each pigment (emission + ambient + diffuse L_D) + phong L_S.
Vec3d povs_color(const std::string& text, const PovLight& light) {
  const auto layers =
      matches(text, "pigment \\{ " + kColor + " \\} finish \\{ (?:emission " + kColor +
                        " )?ambient " + kColor + " diffuse " + kNumber + "(?: (?:phong|specular) " +
                        kNumber + " (?:phong_size|roughness) " + kNumber + ")? \\}");
  Vec3d sum;
  for (const Match& m : layers) {
    const Vec3d received = light.color * (std::stod(m[13]) * light.diffuse);
    sum = sum + modulate(color_of(m), color_of(m, 5) + color_of(m, 9) + received);
    if (!m[14].empty()) sum = sum + light.color * (std::stod(m[14]) * light.specular);
  }
  const bool is_average = text.find("average texture_map") != text.npos;
  EXPECT_EQ(is_average, layers.size() > 1);
  EXPECT_EQ(occurrences(text, "[1 "), is_average ? int(layers.size()) : 0);
  return sum / double(layers.size());
}

Vec3d light_color(const std::string& text) {
  const auto found = matches(text, "light_source \\{ " + kVector + " " + kColor);
  return found.empty() ? Vec3d{} : color_of(found[0], 4);
}

constexpr double kTerms[][2] = {{0, 0}, {1, 0}, {0, 1}, {0.25, 0.75}, {0.9, 0.5}};
constexpr double kRounding = 1e-13;      // a few sums of numbers up to ten
constexpr double kPrintedDigits = 1e-6;  // the error of M and W of YIQ as inverses

/// The text's colour is the formula's for light of every strength.
void expect_adds_up(const Scene& scene, const Shot& shot, double tolerance) {
  const std::string text = scene_text(scene, shot.stage, shot.material);
  const Lighting<double> lighting = lighting_of<double>(scene.view, shot.material);
  const Vec3d value = texture_value(std::get<Vec3d>(scene.texture), shot.material);
  for (const auto& [d, s] : kTerms) {
    const Vec3d color = lighting.lights[0].color;
    const Vec3d expected = stage_color(value, Terms<double>{color * d, color * s}, lighting, shot);
    expect_near(povs_color(text, {light_color(text), d, s}), expected, tolerance);
  }
}

/// A scene in which all weights and colours differ.
Scene colorful_scene() {
  Scene scene = small_scene(Vec3d{0.6, 0.4, 0.2});
  scene.view.ambient = 0.3;
  scene.view.ambient_color = {1, 0.8, 0.5};
  scene.view.lights = {
      PointLight{.position = {-1.5, -3, 3.5}, .color = {{0.9, 0.7, 1}, 1.5}, .falloff = {}}};
  return scene;
}

Material colorful(std::string_view formula) {
  Material m = material(formula);
  m.diffuse = 0.8;
  m.specular = 0.7;
  m.emissive = {0.05, 0.1, 0};
  m.ambient_color = {0.5, 1, 0.25};
  m.diffuse_color = {0.9, 0.5, 0};
  m.specular_color = {1, 0.5, 0.25};
  return m;
}

TEST(PovScene, finishes_add_up_to_the_shot) {
  const Scene scene = colorful_scene();
  for (const char* formula : {"rgb-phong", "rgb-blinn-phong", "yiq-phong", "yiq-collapsed-phong",
                              "yiq-baked-phong", "yuv601-phong", "yuv709-blinn-phong"}) {
    SCOPED_TRACE(formula);
    Material m = colorful(formula);
    for (const Stage stage : {Stage::kTexture, Stage::kDiffuse, Stage::kSpecular, Stage::kFinal}) {
      expect_adds_up(scene, {"shot", stage, m}, kPrintedDigits);
    }
    if (m.space != Space::kRgb) m.luma_offset = -0.1;
    expect_adds_up(scene, {"shot", Stage::kFinal, m}, kPrintedDigits);
  }
}

TEST(PovScene, tints_of_highlights_and_of_the_diffuse_term_add_up) {
  const Scene scene = colorful_scene();
  const Vec3d tints[] = {{1, 1, 1}, {0.5, 0.5, 0.5}, {0, 0, 0}, {1, 0.5, 0.25}, {0.01, 1, 0.3}};
  for (const Vec3d& diffuse : tints) {
    for (const Vec3d& specular : tints) {
      Material m = colorful("rgb-phong");
      m.diffuse_color = diffuse;
      m.specular_color = specular;
      expect_adds_up(scene, {"shot", Stage::kFinal, m}, kRounding);
    }
  }
  Material gold = colorful("rgb-phong");  // no diffuse light where there are no highlights
  gold.specular_color = {1, 0.5, 0};
  expect_adds_up(scene, {"shot", Stage::kFinal, gold}, kRounding);
}

TEST(PovScene, models_without_their_own_term_are_drawn_as_lambert_and_phong) {
  const Scene scene = colorful_scene();
  const auto same = [&](const Material& a, const Material& b) {
    return scene_text(scene, Stage::kFinal, a) == scene_text(scene, Stage::kFinal, b);
  };
  Material rough = colorful("rgb-oren-nayar");
  rough.parameters["roughness"] = 0;
  EXPECT_TRUE(same(rough, colorful("rgb-phong")));
  EXPECT_TRUE(same(colorful("rgb-minnaert"), colorful("rgb-phong")));
}

TEST(PovScene, three_forms_of_a_linear_space_are_one_scene) {
  const Scene scene = small_scene();
  const std::string matrices = scene_text(scene, Stage::kFinal, material("yiq-phong"));
  EXPECT_EQ(scene_text(scene, Stage::kFinal, material("yiq-collapsed-phong")), matrices);
  EXPECT_EQ(scene_text(scene, Stage::kFinal, material("yiq-baked-phong")), matrices);
  EXPECT_NE(scene_text(scene, Stage::kFinal, material("yuv601-phong")), matrices);
}

TEST(PovScene, highlights_are_phongs_or_blinns_with_the_scenes_exponent) {
  const auto text = [](const char* formula) {
    Material m = material(formula);
    m.parameters["shininess"] = 8;
    return scene_text(small_scene(), Stage::kFinal, m);
  };
  EXPECT_THAT(text("rgb-phong"), HasSubstr("phong 1 phong_size 8"));
  EXPECT_THAT(text("rgb-blinn-phong"), HasSubstr("specular 1 roughness 0.125"));
}

TEST(PovScene, tinted_image_is_an_average_of_its_channels) {
  Material m;
  m.diffuse_color = {1, 0.5, 0.25};
  const std::string text = scene_text(small_scene(), Stage::kFinal, m);
  EXPECT_EQ(occurrences(text, "#declare Image = function"), 1);
  EXPECT_THAT(text,
              HasSubstr("Image(x, y, z).green / 2 } color_map { [0 rgb 0] [1 rgb <0, 3, 0>]"));
  EXPECT_THAT(scene_text(small_scene(Vec3d{}), Stage::kFinal, m), Not(HasSubstr("Image")));
  EXPECT_THAT(scene_text(small_scene(), Stage::kFinal, Material{}), Not(HasSubstr("Image")));
}

TEST(PovScene, layers_are_as_many_as_the_formula_needs_each_weighing_that_much_more) {
  const Scene scene = small_scene();
  const auto emission = [&](const char* name) {
    std::vector<double> found;
    for (const auto& m :
         matches(scene_text(scene, Stage::kFinal, material(name)), "emission rgb " + kNumber)) {
      found.push_back(std::stod(m[1]));
    }
    return found;
  };
  using ::testing::DoubleEq;
  const double ambient = scene.view.ambient;
  EXPECT_THAT(emission("phong"), ElementsAre());
  EXPECT_THAT(emission("yiq-eq6"), ElementsAre(2, DoubleEq(2 * (ambient - 1))));
  EXPECT_THAT(emission("yiq-table1"), ElementsAre(3, DoubleEq(3 * (ambient - 1)), DoubleEq(-0.3)));
}

TEST(PovScene, is_lit_from_both_sides_only_for_free_highlights_without_a_diffuse_term) {
  const Scene scene = small_scene();
  const auto is_double = [&](Stage stage, const Material& m) {
    return occurrences(scene_text(scene, stage, m), "double_illuminate") == 1;
  };
  for (const char* formula : {"rgb-phong", "yiq-phong", "rgb-blinn-phong"}) {
    const Material m = material(formula);
    Material dark = m, gated = m;
    dark.diffuse = 0;
    gated.diffuse = 0;
    gated.highlights = Highlights::kGated;
    EXPECT_FALSE(is_double(Stage::kTexture, m)) << formula;
    EXPECT_FALSE(is_double(Stage::kDiffuse, m)) << formula;
    EXPECT_FALSE(is_double(Stage::kDiffuse, dark)) << formula;
    EXPECT_TRUE(is_double(Stage::kSpecular, m)) << formula;
    EXPECT_FALSE(is_double(Stage::kSpecular, gated)) << formula;
    EXPECT_FALSE(is_double(Stage::kFinal, m)) << formula;
    EXPECT_TRUE(is_double(Stage::kFinal, dark)) << formula;
    EXPECT_FALSE(is_double(Stage::kFinal, gated)) << formula;
  }
}

TEST(PovScene, object_casts_no_shadow_and_gamma_is_off) {
  const std::string text = scene_text(small_scene(), Stage::kFinal, material("yiq-eq6"));
  EXPECT_THAT(text, HasSubstr("no_shadow"));
  EXPECT_THAT(text, HasSubstr("assumed_gamma 1.0"));
  EXPECT_EQ(occurrences(text, "image_map"), occurrences(text, "gamma 1.0 interpolate 2"));
  EXPECT_THAT(text, HasSubstr("MESH\n"));
}

TEST(PovScene, plain_color_needs_no_image) {
  for (const NamedMaterial& named : paper_materials()) {
    const std::string text =
        scene_text(small_scene(Vec3d{1, 0, 0}), Stage::kFinal, material(named.name));
    EXPECT_THAT(text, Not(HasSubstr("image_map"))) << named.name;
    EXPECT_THAT(text, Not(HasSubstr("png"))) << named.name;
  }
}

TEST(PovScene, images_are_read_where_the_formula_needs_them) {
  const Scene scene = small_scene();
  const std::string phong = scene_text(scene, Stage::kFinal, material("phong"));
  EXPECT_THAT(phong, HasSubstr("\"texture.png\""));
  EXPECT_THAT(phong, Not(HasSubstr("yiq-luma.png\"")));
  const std::string yiq = scene_text(scene, Stage::kFinal, material("yiq-eq6"));
  EXPECT_EQ(occurrences(yiq, "\"texture.png\""), 1);
  EXPECT_EQ(occurrences(yiq, "yiq-luma.png\""), 1);
}

TEST(PovScene, braces_are_closed) {
  for (const NamedMaterial& named : paper_materials()) {
    const std::string text = scene_text(small_scene(), Stage::kFinal, material(named.name));
    EXPECT_EQ(occurrences(text, "{"), occurrences(text, "}")) << named.name;
    EXPECT_EQ(occurrences(text, "["), occurrences(text, "]")) << named.name;
  }
}

TEST(PovMesh, numbers_read_back_as_the_mesh_in_float32) {
  const TriangleMesh mesh = small_scene().mesh;
  const std::string text = pov_mesh(mesh);
  const std::string& n = kNumber;
  const auto vectors = matches(text, "<" + n + "," + n + "," + n + ">");
  const std::size_t count = mesh.positions.size();
  ASSERT_EQ(vectors.size(), 2 * count + mesh.triangles.size());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(float(vector_of(vectors[i]).x), float(mesh.positions[i].x));
    EXPECT_EQ(float(vector_of(vectors[i]).z), float(mesh.positions[i].z));
    EXPECT_EQ(float(vector_of(vectors[count + i]).y), float(mesh.normals[i].y));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec3d t = vector_of(vectors[2 * count + i]);
    EXPECT_EQ((Triangle{std::uint32_t(t.x), std::uint32_t(t.y), std::uint32_t(t.z)}),
              mesh.triangles[i]);
  }
  EXPECT_EQ(matches(text, "<" + n + "," + n + ">").size(), mesh.uvs.size());
  EXPECT_THAT(text, HasSubstr("face_indices { " + std::to_string(mesh.triangles.size())));
}

}  // namespace
}  // namespace lumaknot::povray
