#include "scene/scene_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/presets.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;

SceneSpec read(std::string_view text) { return scene_from_json(text, "scene.json"); }

/// A scene in which no two numbers agree and none is a default, so that no two fields can swap.
SceneSpec unusual_scene() {
  SceneSpec scene;
  scene.mesh = KnotSpec{-5, 7, 2.5, 0.75, 0.125, 301, 17, 11, 3};
  scene.texture = PlainColor{{0.25, 0.5, 1.0}};
  scene.view.camera = {{1.5, -6.25, 3.75}, {0.1, 0.2, 0.3}, {0.4, 0.6, 0.8}, 33.3};
  scene.view.light.position = {-9.5, 8.5, 7.5};
  scene.view.ambient = 1.0 / 3.0;
  scene.view.material = {Model::kPhong, Space::kYiq, 13.5,           0.9,
                         0.7,           -0.05,       Clamp::kTable1, NormalUse::kInterpolated};
  scene.view.image = {321, 123, 5};
  return scene;
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
    scene.view.ambient = value;
    EXPECT_EQ(read(scene_to_json(scene)).view.ambient, value);
  }
}

TEST(SceneJson, every_field_of_an_unusual_scene_comes_back) {
  const SceneSpec again = read(scene_to_json(unusual_scene()));
  const auto& knot = std::get<KnotSpec>(again.mesh);
  EXPECT_EQ(knot.p, -5);
  EXPECT_EQ(knot.q, 7);
  EXPECT_EQ(knot.ring_radius, 2.5);
  EXPECT_EQ(knot.winding_radius, 0.75);
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
  EXPECT_EQ(again.view.light.position, (Vec3d{-9.5, 8.5, 7.5}));
  EXPECT_EQ(again.view.ambient, 1.0 / 3.0);
}

TEST(SceneJson, every_field_of_an_unusual_material_and_image_comes_back) {
  const SceneSpec again = read(scene_to_json(unusual_scene()));
  const Material& m = again.view.material;
  EXPECT_EQ(m.space, Space::kYiq);
  EXPECT_EQ(m.shininess, 13.5);
  EXPECT_EQ(m.diffuse, 0.9);
  EXPECT_EQ(m.specular, 0.7);
  EXPECT_EQ(m.luma_offset, -0.05);
  EXPECT_EQ(m.clamp, Clamp::kTable1);
  EXPECT_EQ(m.normal, NormalUse::kInterpolated);
  EXPECT_EQ(again.view.image.width, 321);
  EXPECT_EQ(again.view.image.height, 123);
  EXPECT_EQ(again.view.image.samples, 5);
}

TEST(SceneJson, fields_are_written_under_their_published_keys) {
  const Json json = Json::parse(scene_to_json(unusual_scene()));
  EXPECT_EQ(json["mesh"], Json::parse(R"({"knot": {"p": -5, "q": 7, "ring": 2.5, "winding": 0.75,
      "tube": 0.125, "segments": 301, "sides": 17, "repeat_u": 11, "repeat_v": 3}})"));
  EXPECT_EQ(json["texture"], Json::parse(R"({"color": [0.25, 0.5, 1.0]})"));
  EXPECT_EQ(json["camera"], Json::parse(R"({"position": [1.5, -6.25, 3.75],
      "target": [0.1, 0.2, 0.3], "up": [0.4, 0.6, 0.8], "fov_degrees": 33.3})"));
  EXPECT_EQ(json["light"], Json::parse(R"({"position": [-9.5, 8.5, 7.5]})"));
  EXPECT_EQ(json["material"], Json::parse(R"({"model": "phong", "space": "yiq", "shininess": 13.5,
      "diffuse": 0.9, "specular": 0.7, "luma_offset": -0.05, "clamp": "table1",
      "normal": "interpolated"})"));
  EXPECT_EQ(json["image"], Json::parse(R"({"width": 321, "height": 123, "samples": 5})"));
}

TEST(SceneJson, an_empty_object_is_the_default_scene) {
  EXPECT_EQ(scene_to_json(read("{}")), scene_to_json(SceneSpec{}));
}

TEST(SceneJson, empty_objects_at_every_depth_keep_the_defaults) {
  const std::string text = R"({"mesh": {"knot": {}}, "camera": {}, "light": {}, "material": {},
                               "image": {}})";
  EXPECT_EQ(scene_to_json(read(text)), scene_to_json(SceneSpec{}));
}

TEST(SceneJson, defaults_are_the_paper_s_grid_and_picture) {
  const SceneSpec scene = read("{}");
  const auto& knot = std::get<KnotSpec>(scene.mesh);
  EXPECT_EQ(knot.segments, 768);  // the one solution of (a+1)(b+1) = 31529, 2ab = 61440
  EXPECT_EQ(knot.sides, 40);
  EXPECT_TRUE(std::holds_alternative<Bricks>(scene.texture));
  EXPECT_EQ(scene.view.ambient, 0.1);              // AmbientValue of Table 1
  EXPECT_EQ(scene.view.material.shininess, 55.0);  // SpecularPower of Table 1
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
  EXPECT_EQ(read(R"({"light": {"position": [1, 2, 3]}})").view.light.position, (Vec3d{1, 2, 3}));
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
