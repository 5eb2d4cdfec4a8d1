#include "scene/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/presets.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;

SceneSpec read(std::string_view text) { return scene_from_json(text, "scene.json"); }

Material unusual_material() {
  Material m;
  m.model = Model::kOrenNayar;
  m.space = Space::kYuv709;
  m.form = Form::kCollapsed;
  m.parameters["shininess"] = 13.5;
  m.parameters["roughness"] = 0.45;
  m.parameters["reflectance"] = 0.035;
  m.parameters["darkness"] = 1.25;
  m.diffuse = 0.9;
  m.specular = 0.7;
  m.ambient_color = {0.11, 0.12, 0.13};
  m.diffuse_color = {0.21, 0.22, 0.23};
  m.specular_color = {0.31, 0.32, 0.33};
  m.emissive = {0.41, 0.42, 0.43};
  m.luma_offset = -0.05;
  m.clamp = Clamp::kTable1;
  m.gamut = Gamut::kChroma;
  m.normal = NormalUse::kInterpolated;
  m.highlights = Highlights::kGated;
  m.rate = ShadingFrequency::kVertex;
  return m;
}

/// A scene in which no two numbers agree and none is a default, so that no two fields can swap.
SceneSpec unusual_scene() {
  SceneSpec scene;
  scene.mesh =
      KnotSpec{Convention::kBlender, -5, 7, 2.5, 0.75, 0.125, 301, 17, 11, 3, FrameRule::kFrenet,
               Unwrap::kParameter};
  scene.texture = PlainColor{{0.25, 0.5, 1.0}};
  scene.view.camera = {{1.5, -6.25, 3.75}, {0.1, 0.2, 0.3}, {0.4, 0.6, 0.8}, 33.3};
  scene.view.lights = {PointLight{.position = {-9.5, 8.5, 7.5}, .color = {}, .falloff = {}}};
  scene.view.ambient = 1.0 / 3.0;
  scene.view.ambient_color = {0.85, 0.95, 0.65};
  scene.view.material = unusual_material();
  scene.view.image = {321, 123, 5};
  return scene;
}

TEST(SceneJson, a_convention_brings_its_own_defaults) {
  const auto knot = [](const std::string& fields) {
    return std::get<KnotSpec>(read(R"({"mesh": {"knot": {)" + fields + "}}}").mesh);
  };
  const KnotSpec three = knot(R"("convention": "three")");
  EXPECT_EQ(three.minor_radius, 0.5);
  EXPECT_EQ(three.tube_radius, 0.4);
  EXPECT_EQ(three.segments, 64);
  EXPECT_EQ(three.frames, FrameRule::kThree);
  const KnotSpec large = knot(R"("ring": 10, "tube": 3, "convention": "three")");
  EXPECT_EQ(large.minor_radius, 5);  // it follows the ring
  EXPECT_EQ(large.tube_radius, 3);
  EXPECT_EQ(knot(R"("convention": "babylon")").major_radius, 2);
  EXPECT_EQ(knot(R"("convention": "blender")").segments, 99);
  EXPECT_EQ(knot("").segments, 768);
}

TEST(SceneJson, every_builtin_scene_reads_back_as_itself) {
  for (const NamedScene& scene : named_scenes()) {
    const std::string text = scene_to_json(*builtin_scene(scene.name));
    EXPECT_EQ(scene_to_json(read(text)), text) << scene.name;
  }
}

TEST(SceneJson, every_alternative_of_mesh_and_texture_reads_back_as_itself) {
  for (const MeshSpec& mesh :
       {MeshSpec{KnotSpec{}}, MeshSpec{MeshFile{"dir/a \"mesh\" \\ é.obj"}}}) {
    for (const TextureSpec& texture :
         {TextureSpec{Bricks{}}, TextureSpec{TextureFile{"../wall.png"}},
          TextureSpec{PlainColor{{0, 1, 0.1}}}}) {
      SceneSpec scene;
      scene.mesh = mesh;
      scene.texture = texture;
      const SceneSpec again = read(scene_to_json(scene));
      EXPECT_EQ(again.mesh.index(), mesh.index());
      EXPECT_EQ(again.texture.index(), texture.index());
      EXPECT_EQ(scene_to_json(again), scene_to_json(scene));
    }
  }
}

TEST(SceneJson, file_names_come_back_as_written) {
  SceneSpec scene;
  scene.mesh = MeshFile{"dir/a \"mesh\" \\ é.obj"};
  scene.texture = TextureFile{"../wall.png"};
  const SceneSpec again = read(scene_to_json(scene));
  EXPECT_EQ(std::get<MeshFile>(again.mesh).path, "dir/a \"mesh\" \\ é.obj");
  EXPECT_EQ(std::get<TextureFile>(again.texture).path, "../wall.png");
}

TEST(SceneJson, doubles_survive_to_the_last_bit) {
  for (const double value : {0.1 + 0.2, 1.0 / 3.0, 1e-310, 5e-324, 1.7976931348623157e308}) {
    SceneSpec scene;
    scene.view.material.parameters["shininess"] = value;
    EXPECT_EQ(read(scene_to_json(scene)).view.material.parameters["shininess"], value);
  }
}

TEST(SceneJson, every_field_of_an_unusual_scene_comes_back) {
  const SceneSpec again = read(scene_to_json(unusual_scene()));
  const auto& knot = std::get<KnotSpec>(again.mesh);
  EXPECT_EQ(knot.p, -5);
  EXPECT_EQ(knot.q, 7);
  EXPECT_EQ(knot.major_radius, 2.5);
  EXPECT_EQ(knot.minor_radius, 0.75);
  EXPECT_EQ(knot.tube_radius, 0.125);
  EXPECT_EQ(knot.segments, 301);
  EXPECT_EQ(knot.sides, 17);
  EXPECT_EQ(knot.repeat_u, 11);
  EXPECT_EQ(knot.repeat_v, 3);
  EXPECT_EQ(std::get<PlainColor>(again.texture).rgb, (Vec3d{0.25, 0.5, 1.0}));
  EXPECT_EQ(again.view.camera.position, (Vec3d{1.5, -6.25, 3.75}));
  EXPECT_EQ(again.view.camera.target, (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(again.view.camera.up, (Vec3d{0.4, 0.6, 0.8}));
  EXPECT_EQ(again.view.camera.fov_degrees, 33.3);
  ASSERT_EQ(again.view.lights.size(), 1u);
  EXPECT_EQ(std::get<PointLight>(again.view.lights[0]).position, (Vec3d{-9.5, 8.5, 7.5}));
  EXPECT_EQ(again.view.ambient, 1.0 / 3.0);
  EXPECT_EQ(again.view.ambient_color, (Vec3d{0.85, 0.95, 0.65}));
}

TEST(SceneJson, every_number_and_colour_of_an_unusual_material_comes_back) {
  const Material m = read(scene_to_json(unusual_scene())).view.material;
  EXPECT_EQ(m.parameters["shininess"], 13.5);
  EXPECT_EQ(m.parameters["roughness"], 0.45);
  EXPECT_EQ(m.parameters["reflectance"], 0.035);
  EXPECT_EQ(m.parameters["darkness"], 1.25);
  EXPECT_EQ(m.diffuse, 0.9);
  EXPECT_EQ(m.specular, 0.7);
  EXPECT_EQ(m.ambient_color, (Vec3d{0.11, 0.12, 0.13}));
  EXPECT_EQ(m.diffuse_color, (Vec3d{0.21, 0.22, 0.23}));
  EXPECT_EQ(m.specular_color, (Vec3d{0.31, 0.32, 0.33}));
  EXPECT_EQ(m.emissive, (Vec3d{0.41, 0.42, 0.43}));
  EXPECT_EQ(m.luma_offset, -0.05);
}

TEST(SceneJson, every_choice_of_an_unusual_material_comes_back) {
  const Material m = read(scene_to_json(unusual_scene())).view.material;
  EXPECT_EQ(m.model, Model::kOrenNayar);
  EXPECT_EQ(m.space, Space::kYuv709);
  EXPECT_EQ(m.form, Form::kCollapsed);
  EXPECT_EQ(m.clamp, Clamp::kTable1);
  EXPECT_EQ(m.gamut, Gamut::kChroma);
  EXPECT_EQ(m.normal, NormalUse::kInterpolated);
  EXPECT_EQ(m.highlights, Highlights::kGated);
  EXPECT_EQ(m.rate, ShadingFrequency::kVertex);
}

TEST(SceneJson, every_field_of_an_unusual_image_comes_back) {
  const SceneSpec again = read(scene_to_json(unusual_scene()));
  EXPECT_EQ(again.view.image.width, 321);
  EXPECT_EQ(again.view.image.height, 123);
  EXPECT_EQ(again.view.image.samples, 5);
}

TEST(SceneJson, fields_are_written_under_their_published_keys) {
  const Json json = Json::parse(scene_to_json(unusual_scene()));
  EXPECT_EQ(json["mesh"], Json::parse(R"({"knot": {"convention": "blender", "p": -5, "q": 7,
      "ring": 2.5, "winding": 0.75, "tube": 0.125, "segments": 301, "sides": 17, "repeat_u": 11,
      "repeat_v": 3, "frames": "frenet", "unwrap": "parameter"}})"));
  EXPECT_EQ(json["texture"], Json::parse(R"({"color": [0.25, 0.5, 1.0]})"));
  EXPECT_EQ(json["camera"], Json::parse(R"({"position": [1.5, -6.25, 3.75],
      "target": [0.1, 0.2, 0.3], "up": [0.4, 0.6, 0.8], "fov_degrees": 33.3})"));
  EXPECT_EQ(json["lights"], Json::parse(R"([{"point": {"position": [-9.5, 8.5, 7.5],
      "color": [1, 1, 1], "intensity": 1, "constant": 1, "linear": 0, "quadratic": 0}}])"));
  EXPECT_EQ(json["ambient_color"], Json::parse("[0.85, 0.95, 0.65]"));
  EXPECT_EQ(json["material"], Json::parse(R"({"model": "oren-nayar", "space": "yuv709",
      "form": "collapsed", "shininess": 13.5, "roughness": 0.45, "reflectance": 0.035,
      "darkness": 1.25, "diffuse": 0.9, "specular": 0.7, "ambient_color": [0.11, 0.12, 0.13],
      "diffuse_color": [0.21, 0.22, 0.23], "specular_color": [0.31, 0.32, 0.33],
      "emissive": [0.41, 0.42, 0.43], "luma_offset": -0.05, "clamp": "table1", "gamut": "chroma",
      "normal": "interpolated", "highlights": "gated", "rate": "vertex"})"));
  EXPECT_EQ(json["image"], Json::parse(R"({"width": 321, "height": 123, "samples": 5})"));
}

TEST(SceneJson, an_empty_object_is_the_default_scene) {
  EXPECT_EQ(scene_to_json(read("{}")), scene_to_json(SceneSpec{}));
}

TEST(SceneJson, empty_objects_at_every_depth_keep_the_defaults) {
  const std::string text = R"({"mesh": {"knot": {}}, "camera": {}, "lights": [{"point": {}}],
                               "material": {}, "image": {}})";
  EXPECT_EQ(scene_to_json(read(text)), scene_to_json(SceneSpec{}));
}

TEST(SceneJson, defaults_are_the_paper_s_grid_and_picture) {
  const SceneSpec scene = read("{}");
  const auto& knot = std::get<KnotSpec>(scene.mesh);
  EXPECT_EQ(knot.segments, 768);  // the one solution of (a+1)(b+1) = 31529, 2ab = 61440
  EXPECT_EQ(knot.sides, 40);
  EXPECT_TRUE(std::holds_alternative<Bricks>(scene.texture));
  EXPECT_EQ(scene.view.ambient, 0.1);                            // AmbientValue of Table 1
  EXPECT_EQ(scene.view.material.parameters["shininess"], 55.0);  // SpecularPower of Table 1
  EXPECT_EQ(scene.view.image.width, 720);
  EXPECT_EQ(scene.view.image.height, 720);
}

TEST(SceneJson, one_given_key_leaves_its_neighbours_at_their_defaults) {
  const SceneSpec scene = read(R"({"camera": {"fov_degrees": 30}})");
  EXPECT_EQ(scene.view.camera.fov_degrees, 30);
  EXPECT_EQ(scene.view.camera.position, Camera{}.position);
  EXPECT_EQ(scene.view.image.width, ImageSpec{}.width);
}

TEST(SceneJson, numbers_without_a_fraction_serve_where_a_length_is_asked) {
  EXPECT_EQ(read(R"({"ambient": 1})").view.ambient, 1.0);
  EXPECT_EQ(read(R"({"camera": {"position": [1, 2, 3]}})").view.camera.position, (Vec3d{1, 2, 3}));
}

TEST(SceneJson, the_order_of_keys_does_not_matter) {
  EXPECT_EQ(scene_to_json(read(R"({"ambient": 0.2, "image": {"height": 9, "width": 8}})")),
            scene_to_json(read(R"({"image": {"width": 8, "height": 9}, "ambient": 0.2})")));
}

TEST(SceneJson, written_text_ends_in_one_newline) {
  const std::string text = scene_to_json(SceneSpec{});
  EXPECT_TRUE(text.ends_with("}\n"));
}

TEST(SceneJson, the_same_scene_gives_the_same_bytes) {
  EXPECT_EQ(scene_to_json(unusual_scene()), scene_to_json(unusual_scene()));
}

TEST(SceneJson, values_at_the_ends_of_closed_ranges_are_accepted) {
  const SceneSpec scene = read(R"({"mesh": {"knot": {"segments": 3, "sides": 3}},
      "texture": {"color": [0, 0, 1]}, "ambient": 0,
      "material": {"shininess": 0, "diffuse": 0, "specular": 0},
      "image": {"width": 1, "height": 1, "samples": 64}})");
  EXPECT_EQ(std::get<KnotSpec>(scene.mesh).segments, 3);
  EXPECT_EQ(scene.view.image.samples, 64);
}

}  // namespace
}  // namespace lumaknot
