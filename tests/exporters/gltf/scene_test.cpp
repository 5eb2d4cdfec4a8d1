#include "exporters/gltf/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "math/angle.h"
#include "tests/exporters/gltf/testing.h"

namespace lumaknot::gltf {
namespace {

using ::testing::ElementsAre;
using testing::GltfParts;
using testing::Json;

constexpr double kRounding = 1e-12;  // a few operations in double on numbers about 1

GltfParts exported(const Scene& scene) {
  return testing::parts_of(glb_package(scene, "knot").back().bytes);
}

/// The KHR_lights_punctual entry of a scene with this light and the camera's target at `target`.
Json exported_light(const Light& light, const Vec3d& target = {}) {
  Scene scene = testing::small_scene();
  scene.view.lights = {light};
  scene.view.camera.target = target;
  return exported(scene).json["extensions"]["KHR_lights_punctual"]["lights"][0];
}

Json node_of(const Scene& scene, std::string_view name) {
  const Json json = exported(scene).json;
  for (const Json& node : json["nodes"]) {
    if (node["name"] == name) return node;
  }
  return {};
}

/// The image of a point or, with w = 0, a vector under a node's matrix, in our frame.
Vec3d placed(const Json& node, const Vec3d& v, double w = 1) {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (node.contains("matrix")) m = node["matrix"].get<std::array<double, 16>>();
  const auto row = [&](std::size_t r) {
    return m[r] * v.x + m[4 + r] * v.y + m[8 + r] * v.z + m[12 + r] * w;
  };
  return {row(0), -row(2), row(1)};
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(components(a)[c], components(b)[c], kRounding);
}

TEST(GltfScene, the_camera_has_our_position_and_direction) {
  const Scene scene = testing::small_scene();
  const Camera& camera = scene.view.camera;
  const Json node = node_of(scene, "camera");
  const CameraFrame frame = camera_frame(camera);
  expect_near(placed(node, {0, 0, 0}), camera.position);
  expect_near(placed(node, {1, 0, 0}, 0), frame.right);
  expect_near(placed(node, {0, 1, 0}, 0), frame.up);
  expect_near(placed(node, {0, 0, -1}, 0), normalize(camera.target - camera.position));
}

TEST(GltfScene, the_camera_has_our_field_of_view_and_near_depth) {
  Scene scene = testing::small_scene();
  scene.view.camera = {.position = {0, -4, 3}, .target = {}, .fov_degrees = 60};
  scene.view.image = {.width = 640, .height = 480};
  const Json camera = exported(scene).json["cameras"][0];
  EXPECT_EQ(camera["type"], "perspective");
  EXPECT_NEAR(camera["perspective"]["yfov"].get<double>(), kPi / 3, kRounding);
  EXPECT_NEAR(camera["perspective"]["aspectRatio"].get<double>(), 4.0 / 3, kRounding);
  EXPECT_NEAR(camera["perspective"]["znear"].get<double>(), 0.005, kRounding);  // |(0,-4,3)| = 5
}

TEST(GltfScene, a_quadratic_falloff_is_matched_at_every_distance) {
  const Light light = PointLight{{1, 2, 3}, {{1, 1, 1}, 3}, {0, 0, 0.5}};
  for (const Vec3d& target : {Vec3d{0, 0, 0}, Vec3d{9, 9, 9}, Vec3d{1, 2, 3}}) {
    const Json json = exported_light(light, target);
    EXPECT_EQ(json["type"], "point");
    // baseColor / pi * I / d^2 = baseColor * 3 / (0.5 d^2)
    EXPECT_NEAR(json["intensity"].get<double>(), kPi * 6, kRounding);
  }
}

TEST(GltfScene, another_falloff_is_matched_at_the_target) {
  const Light light = PointLight{{0, 0, 2}, {{1, 1, 1}, 1}, {1, 0.5, 0.25}};
  // At d = 2 ours is 1 / (1 + 1 + 1); glTF's is I / 4 / pi.
  EXPECT_NEAR(exported_light(light)["intensity"].get<double>(), 4 * kPi / 3, kRounding);
}

TEST(GltfScene, a_directional_light_has_lux_and_shines_along_its_node) {
  Scene scene = testing::small_scene();
  const Vec3d direction{1, -2, 2};
  scene.view.lights = {DirectionalLight{direction, {{1, 1, 1}, 0.5}}};
  const Json light = exported(scene).json["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_EQ(light["type"], "directional");
  EXPECT_NEAR(light["intensity"].get<double>(), kPi / 2, kRounding);
  expect_near(placed(node_of(scene, "light0"), {0, 0, -1}, 0), direction / 3.0);
}

TEST(GltfScene, a_spot_light_has_half_angles_in_radians_and_its_place) {
  Scene scene = testing::small_scene();
  const SpotLight spot{{1, 2, 3}, {0, 0, -2}, 15, 30, {}, {0, 0, 1}};
  scene.view.lights = {spot};
  const Json light = exported(scene).json["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_EQ(light["type"], "spot");
  EXPECT_NEAR(light["intensity"].get<double>(), kPi, kRounding);
  EXPECT_NEAR(light["spot"]["innerConeAngle"].get<double>(), kPi / 12, kRounding);
  EXPECT_NEAR(light["spot"]["outerConeAngle"].get<double>(), kPi / 6, kRounding);
  const Json node = node_of(scene, "light0");
  expect_near(placed(node, {0, 0, 0}), spot.position);
  expect_near(placed(node, {0, 0, -1}, 0), {0, 0, -1});
}

TEST(GltfScene, cones_beyond_the_limit_of_glTF_become_its_widest) {
  const Json cone = exported_light(SpotLight{{}, {0, 0, -1}, 100, 170, {}, {}})["spot"];
  EXPECT_NEAR(cone["outerConeAngle"].get<double>(), kPi / 2, kRounding);
  EXPECT_LT(cone["innerConeAngle"], cone["outerConeAngle"]);
}

TEST(GltfScene, plain_colours_are_linear_so_that_viewers_show_the_encoded_one) {
  const Json surface = exported(testing::small_scene(Vec3d{1, 0.5, 0.04}))
                           .json["materials"][0]["pbrMetallicRoughness"];
  const auto factor = surface["baseColorFactor"].get<std::array<double, 4>>();
  EXPECT_EQ(factor[0], 1);
  EXPECT_NEAR(factor[1], std::pow((0.5 + 0.055) / 1.055, 2.4), kRounding);  // IEC 61966-2-1
  EXPECT_NEAR(factor[2], 0.04 / 12.92, kRounding);
  EXPECT_EQ(factor[3], 1);
  EXPECT_FALSE(surface.contains("baseColorTexture"));
}

TEST(GltfScene, the_texture_is_in_the_glb_file_as_png) {
  const GltfParts parts = exported(testing::small_scene());
  const Json& image = parts.json["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  const Json& view = parts.json["bufferViews"][image["bufferView"].get<std::size_t>()];
  EXPECT_EQ(parts.binary.substr(view["byteOffset"].get<std::size_t>(),
                                view["byteLength"].get<std::size_t>()),
            texture_png(testing::small_texture()));
  EXPECT_FALSE(view.contains("target"));
  const Json& sampler = parts.json["samplers"][0];
  EXPECT_EQ(sampler["wrapS"], 10497);  // repeat
  EXPECT_EQ(sampler["wrapT"], 10497);
}

TEST(GltfScene, roughness_follows_the_highlights_width) {
  const auto roughness = [](Material material) {
    Scene scene = testing::small_scene();
    scene.view.material = material;
    return exported(scene)
        .json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"]
        .get<double>();
  };
  Material m = testing::material("rgb-blinn-phong");
  m.parameters["shininess"] = 30;
  EXPECT_NEAR(roughness(m), 0.5, kRounding);  // (2 / 32)^(1/4)
  m = testing::material("rgb-phong");
  m.parameters["shininess"] = 7.5;  // Blinn's 30
  EXPECT_NEAR(roughness(m), 0.5, kRounding);
  m.parameters["shininess"] = 0;
  EXPECT_EQ(roughness(m), 1);
  m.specular = 0;
  m.parameters["shininess"] = 100;
  EXPECT_EQ(roughness(m), 1);
  m = testing::material("rgb-cook-torrance");
  m.parameters["roughness"] = 0.25;
  EXPECT_EQ(roughness(m), 0.25);
}

TEST(GltfScene, none_of_our_numbers_is_lost) {
  Scene scene = testing::small_scene();
  scene.view.material = testing::material("yiq-table1");
  scene.view.ambient = 0.375;
  const Json json = exported(scene).json;
  const Json& material = json["materials"][0]["extras"]["lumaknot"];
  EXPECT_EQ(material["space"], "yiq");
  EXPECT_EQ(material["luma_offset"], -0.1);
  const Json& numbers = json["scenes"][0]["extras"]["lumaknot"];
  EXPECT_EQ(numbers["ambient"], 0.375);
  EXPECT_EQ(numbers["lights"].size(), scene.view.lights.size());
}

TEST(GltfScene, a_scene_without_lights_names_no_extension) {
  Scene scene = testing::small_scene();
  scene.view.lights.clear();
  const Json json = exported(scene).json;
  EXPECT_FALSE(json.contains("extensions"));
  EXPECT_FALSE(json.contains("extensionsUsed"));
}

TEST(GltfPackage, the_document_comes_last_and_names_the_other_files) {
  const Package package = gltf_package(testing::small_scene(), "my knot");
  EXPECT_THAT(testing::names(package),
              ElementsAre("my knot.bin", "my knot.texture.png", "my knot.gltf"));
  const Json json = Json::parse(package.back().bytes);
  EXPECT_EQ(json["images"][0], (Json{{"uri", "my%20knot.texture.png"}}));
  EXPECT_EQ(json["buffers"][0]["uri"], "my%20knot.bin");
  EXPECT_EQ(json["buffers"][0]["byteLength"], package[0].bytes.size());
}

TEST(GltfPackage, a_plain_colour_needs_no_image) {
  const Package package = gltf_package(testing::small_scene(Vec3d{0.5, 0.5, 0.5}), "knot");
  EXPECT_THAT(testing::names(package), ElementsAre("knot.bin", "knot.gltf"));
  EXPECT_FALSE(Json::parse(package.back().bytes).contains("images"));
}

}  // namespace
}  // namespace lumaknot::gltf
