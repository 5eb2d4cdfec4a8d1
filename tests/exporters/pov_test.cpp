#include "exporters/pov.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <regex>

#include "exporters/image_file.h"
#include "tests/exporters/exporters_testing.h"

namespace lumaknot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::material;
using ::testing::Not;
using testing::occurrences;
using testing::small_scene;

const PovNames kNames{"t.png", "y.png"};
const std::string kNumber = R"((-?[0-9.]+(?:e[-+]?[0-9]+)?))";
const std::string kVector = "<" + kNumber + ", " + kNumber + ", " + kNumber + ">";

std::string scene_text(const Scene& scene, Stage stage, const Material& m) {
  return pov_scene(scene, {"shot", stage, m}, kNames, "MESH\n");
}

/// The groups of a match, empty where one took no part; the whole match first.
using Match = std::vector<std::string>;

std::vector<Match> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<Match> all;
  for (std::sregex_iterator m(text.begin(), text.end(), expression), end; m != end; ++m) {
    Match& groups = all.emplace_back();
    for (const auto& group : *m) groups.push_back(group.str());
  }
  return all;
}

Vec3d vector_of(const Match& match, std::size_t first = 1) {
  return {std::stod(match[first]), std::stod(match[first + 1]), std::stod(match[first + 2])};
}

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
  EXPECT_NEAR(length(up), 2 * std::tan(25 * std::numbers::pi / 180), kRounding);
  EXPECT_NEAR(length(right), 1.5 * length(up), kRounding);
  EXPECT_NEAR(dot(direction, right), 0, kRounding);
  EXPECT_NEAR(dot(direction, up), 0, kRounding);
  EXPECT_NEAR(dot(right, up), 0, kRounding);
  EXPECT_GT(dot(cross(right, up), -direction), 0);  // x right, y up, looking along -z
  EXPECT_GT(dot(up, scene.view.camera.up), 0);
  const Vec3d sight = normalize(scene.view.camera.target - scene.view.camera.position);
  EXPECT_NEAR(length(direction - sight), 0, kRounding);
}

TEST(PovScene, light_stands_where_the_scene_says) {
  Scene scene = small_scene();
  scene.view.light.position = {1.25, -1e-7, 3e10};
  const auto found = matches(scene_text(scene, Stage::kFinal, Material{}),
                             "light_source \\{ " + kVector + " rgb 1 \\}");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(vector_of(found[0]), scene.view.light.position);
}

/// What POV-Ray's documented lighting makes of the texture in `text`, whose pigments are plain: the
/// average of its members, each pigment (emission + ambient + diffuse L_D) + phong L_S.
Vec3d povs_color(const std::string& text, double diffuse, double specular) {
  const auto layers =
      matches(text, "pigment \\{ rgb (?:" + kVector + "|" + kNumber + ") \\} finish \\{ emission " +
                        kNumber + " ambient " + kNumber + " diffuse " + kNumber + " phong " +
                        kNumber + " phong_size " + kNumber + " \\}");
  Vec3d sum;
  for (const Match& m : layers) {
    const Vec3d pigment =
        !m[1].empty() ? vector_of(m) : Vec3d{std::stod(m[4]), std::stod(m[4]), std::stod(m[4])};
    const double light = std::stod(m[5]) + std::stod(m[6]) + std::stod(m[7]) * diffuse;
    const double highlight = std::stod(m[8]) * specular;
    sum = sum + pigment * light + Vec3d{highlight, highlight, highlight};
    EXPECT_EQ(std::stod(m[9]), 55);
  }
  const bool is_average = text.find("average texture_map") != text.npos;
  EXPECT_EQ(is_average, layers.size() > 1);
  EXPECT_EQ(occurrences(text, "[1 "), is_average ? int(layers.size()) : 0);
  return sum / double(layers.size());
}

constexpr double kLights[][2] = {{0, 0}, {1, 0}, {0, 1}, {0.25, 0.75}, {0.9, 0.5}};

void expect_near(const Vec3d& a, const Vec3d& b) {
  constexpr double kRounding = 1e-14;  // a few sums of numbers below 3
  EXPECT_NEAR(a.x, b.x, kRounding);
  EXPECT_NEAR(a.y, b.y, kRounding);
  EXPECT_NEAR(a.z, b.z, kRounding);
}

TEST(PovScene, finishes_add_up_to_the_shot) {
  const Vec3d t{0.6, 0.4, 0.2};
  Scene scene = small_scene(t);
  scene.view.ambient = 0.3;
  const double y = 0.29889531 * 0.6 + 0.58662247 * 0.4 + 0.11448223 * 0.2;
  for (const NamedMaterial& named : named_materials()) {
    Material m = named.material;
    m.diffuse = 0.8;
    m.specular = 0.7;
    SCOPED_TRACE(named.name);
    for (const auto& [d, s] : kLights) {
      expect_near(povs_color(scene_text(scene, Stage::kTexture, m), d, s), t);
      expect_near(povs_color(scene_text(scene, Stage::kDiffuse, m), d, s), Vec3d{d, d, d});
      expect_near(povs_color(scene_text(scene, Stage::kSpecular, m), d, s), Vec3d{s, s, s});
      const double light = 0.3 + 0.8 * d, added = 0.7 * s;
      const double shift = y * (light - 1) + added + m.luma_offset;
      expect_near(povs_color(scene_text(scene, Stage::kFinal, m), d, s),
                  m.space == Space::kRgb ? t * light + Vec3d{added, added, added}
                                         : t + Vec3d{shift, shift, shift});
    }
  }
}

TEST(PovScene, layers_are_as_many_as_the_formula_needs_each_weighing_that_much_more) {
  const Scene scene = small_scene();
  const auto emission = [&](const char* name) {
    std::vector<double> found;
    for (const auto& m :
         matches(scene_text(scene, Stage::kFinal, material(name)), "emission " + kNumber)) {
      found.push_back(std::stod(m[1]));
    }
    return found;
  };
  using ::testing::DoubleEq;
  const double ambient = scene.view.ambient;
  EXPECT_THAT(emission("phong"), ElementsAre(0));
  EXPECT_THAT(emission("yiq-eq6"), ElementsAre(2, DoubleEq(2 * (ambient - 1))));
  EXPECT_THAT(emission("yiq-table1"), ElementsAre(3, DoubleEq(3 * (ambient - 1)), DoubleEq(-0.3)));
}

TEST(PovScene, is_lit_from_both_sides_only_where_there_is_no_diffuse_term) {
  const Scene scene = small_scene();
  const auto is_double = [&](Stage stage, const Material& m) {
    return occurrences(scene_text(scene, stage, m), "double_illuminate") == 1;
  };
  for (const NamedMaterial& named : named_materials()) {
    Material dark = named.material;
    dark.diffuse = 0;
    EXPECT_FALSE(is_double(Stage::kTexture, named.material)) << named.name;
    EXPECT_FALSE(is_double(Stage::kDiffuse, named.material)) << named.name;
    EXPECT_FALSE(is_double(Stage::kDiffuse, dark)) << named.name;
    EXPECT_TRUE(is_double(Stage::kSpecular, named.material)) << named.name;
    EXPECT_FALSE(is_double(Stage::kFinal, named.material)) << named.name;
    EXPECT_TRUE(is_double(Stage::kFinal, dark)) << named.name;
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
  for (const NamedMaterial& named : named_materials()) {
    const std::string text = scene_text(small_scene(Vec3d{1, 0, 0}), Stage::kFinal, named.material);
    EXPECT_THAT(text, Not(HasSubstr("image_map"))) << named.name;
    EXPECT_THAT(text, Not(HasSubstr("png"))) << named.name;
  }
}

TEST(PovScene, images_are_read_where_the_formula_needs_them) {
  const Scene scene = small_scene();
  const std::string phong = scene_text(scene, Stage::kFinal, material("phong"));
  EXPECT_THAT(phong, HasSubstr("\"t.png\""));
  EXPECT_THAT(phong, Not(HasSubstr("\"y.png\"")));
  const std::string yiq = scene_text(scene, Stage::kFinal, material("yiq-eq6"));
  EXPECT_EQ(occurrences(yiq, "\"t.png\""), 1);
  EXPECT_EQ(occurrences(yiq, "\"y.png\""), 1);
}

TEST(PovScene, braces_are_closed) {
  for (const NamedMaterial& named : named_materials()) {
    const std::string text = scene_text(small_scene(), Stage::kFinal, named.material);
    EXPECT_EQ(occurrences(text, "{"), occurrences(text, "}")) << named.name;
    EXPECT_EQ(occurrences(text, "["), occurrences(text, "]")) << named.name;
  }
}

TEST(PovShortfall, only_a_final_shot_has_one_and_it_tells_what) {
  const auto shortfall = [](Stage stage, Clamp clamp, NormalUse normal) {
    Material m;
    m.clamp = clamp;
    m.normal = normal;
    return pov_shortfall({"s", stage, m});
  };
  using enum Stage;
  EXPECT_FALSE(shortfall(kFinal, Clamp::kFree, NormalUse::kUnit));
  EXPECT_FALSE(shortfall(kTexture, Clamp::kTable1, NormalUse::kInterpolated));
  EXPECT_EQ(shortfall(kFinal, Clamp::kTable1, NormalUse::kUnit),
            "POV-Ray can't clamp ambient plus diffuse light");
  EXPECT_EQ(shortfall(kFinal, Clamp::kFree, NormalUse::kInterpolated),
            "POV-Ray can't use an interpolated normal without renormalising it");
  const auto both = shortfall(kFinal, Clamp::kTable1, NormalUse::kInterpolated);
  ASSERT_TRUE(both);
  EXPECT_THAT(*both, HasSubstr("clamp"));
  EXPECT_THAT(*both, HasSubstr(" nor "));
  EXPECT_THAT(*both, HasSubstr("interpolated"));
}

TEST(PovMesh, numbers_read_back_as_the_mesh_in_float32) {
  const TriangleMesh mesh = small_scene().mesh;
  const std::string text = pov_mesh(mesh);
  const std::string n = R"((-?[0-9.]+(?:e[-+]?[0-9]+)?))";
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
}  // namespace lumaknot
