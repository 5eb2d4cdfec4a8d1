// Lights in scene.json: each kind written and read back, and the refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/check.h"
#include "scene/json.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::vector<Light> read_lights(const std::string& list) {
  return scene_from_json(R"({"lights": )" + list + "}", "scene.json").view.lights;
}

std::string refusal(const std::string& list) {
  const std::string message = error_of([&] { read_lights(list); });
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  return message;
}

Json written(const std::vector<Light>& lights) {
  SceneSpec scene;
  scene.view.lights = lights;
  return Json::parse(scene_to_json(scene)).at("lights");
}

/// One light of each kind, no number a default, no two the same.
std::vector<Light> unusual_lights() {
  return {PointLight{{1.5, -2.5, 3.5}, {{0.1, 0.2, 0.3}, 4.5}, {0.25, 0.5, 0.75}},
          DirectionalLight{{-1.25, 2.25, -3.25}, {{0.4, 0.5, 0.6}, 5.5}},
          SpotLight{{6.5, 7.5, 8.5},
                    {-0.5, -1.5, -3},
                    12.5,
                    33.5,
                    {{0.7, 0.8, 0.9}, 6.25},
                    {0.125, 0.375, 0.625}}};
}

TEST(Lights, every_kind_is_written_under_its_published_keys) {
  EXPECT_EQ(written(unusual_lights()), Json::parse(R"([
    {"point": {"position": [1.5, -2.5, 3.5], "color": [0.1, 0.2, 0.3], "intensity": 4.5,
               "constant": 0.25, "linear": 0.5, "quadratic": 0.75}},
    {"directional": {"direction": [-1.25, 2.25, -3.25], "color": [0.4, 0.5, 0.6],
                     "intensity": 5.5}},
    {"spot": {"position": [6.5, 7.5, 8.5], "direction": [-0.5, -1.5, -3], "inner_degrees": 12.5,
              "outer_degrees": 33.5, "color": [0.7, 0.8, 0.9], "intensity": 6.25,
              "constant": 0.125, "linear": 0.375, "quadratic": 0.625}}])"));
}

TEST(Lights, a_point_light_comes_back) {
  const std::vector<Light> again = read_lights(written(unusual_lights()).dump());
  ASSERT_EQ(again.size(), 3u);
  const auto& point = std::get<PointLight>(again[0]);
  EXPECT_EQ(point.position, (Vec3d{1.5, -2.5, 3.5}));
  EXPECT_EQ(point.color.rgb, (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(point.color.intensity, 4.5);
  EXPECT_EQ(point.falloff.constant, 0.25);
  EXPECT_EQ(point.falloff.linear, 0.5);
  EXPECT_EQ(point.falloff.quadratic, 0.75);
}

TEST(Lights, a_directional_light_comes_back) {
  const auto light =
      std::get<DirectionalLight>(read_lights(written(unusual_lights()).dump()).at(1));
  EXPECT_EQ(light.direction, (Vec3d{-1.25, 2.25, -3.25}));
  EXPECT_EQ(light.color.rgb, (Vec3d{0.4, 0.5, 0.6}));
  EXPECT_EQ(light.color.intensity, 5.5);
}

TEST(Lights, a_spot_light_comes_back) {
  const auto spot = std::get<SpotLight>(read_lights(written(unusual_lights()).dump()).at(2));
  EXPECT_EQ(spot.position, (Vec3d{6.5, 7.5, 8.5}));
  EXPECT_EQ(spot.direction, (Vec3d{-0.5, -1.5, -3}));
  EXPECT_EQ(spot.inner_degrees, 12.5);
  EXPECT_EQ(spot.outer_degrees, 33.5);
  EXPECT_EQ(spot.color.rgb, (Vec3d{0.7, 0.8, 0.9}));
  EXPECT_EQ(spot.color.intensity, 6.25);
  EXPECT_EQ(spot.falloff.constant, 0.125);
  EXPECT_EQ(spot.falloff.linear, 0.375);
  EXPECT_EQ(spot.falloff.quadratic, 0.625);
}

TEST(Lights, keys_left_out_keep_the_defaults_of_their_kind) {
  EXPECT_EQ(written(read_lights(R"([{"point": {}}, {"directional": {}}, {"spot": {}}])")),
            written({PointLight{}, DirectionalLight{}, SpotLight{}}));
}

TEST(Lights, without_the_key_there_is_one_plain_point_light) {
  EXPECT_EQ(written(scene_from_json("{}", "scene.json").view.lights), written({PointLight{}}));
}

TEST(Lights, a_list_replaces_the_default_light_and_may_be_empty) {
  EXPECT_TRUE(read_lights("[]").empty());
  EXPECT_EQ(read_lights(R"([{"directional": {}}])").size(), 1u);
}

TEST(Lights, their_order_and_number_are_kept) {
  std::vector<Light> lights;
  for (std::size_t i = 0; i < kMaxLights; ++i) {
    lights.push_back(i % 3 ? Light(PointLight{{double(i), 0, 0}, {}, {}})
                           : Light(DirectionalLight{{1, double(i), 0}, {}}));
  }
  EXPECT_EQ(written(read_lights(written(lights).dump())), written(lights));
}

TEST(Lights, seventeen_are_too_many) {
  std::string list = R"([{"point": {}})";
  for (int i = 1; i < 16; ++i) list += R"(, {"point": {}})";
  EXPECT_EQ(refusal(list + "]"), "");
  EXPECT_THAT(refusal(list + R"(, {"point": {}}])"),
              HasSubstr("lights must be a list of at most 16"));
}

TEST(Lights, the_published_schema_gives_their_maximum_number) {
  const Json schema = Json::parse(scene_json_schema());
  EXPECT_EQ(schema["properties"]["lights"]["maxItems"], kMaxLights);
  EXPECT_EQ(schema["properties"]["lights"]["items"]["oneOf"].size(), std::variant_size_v<Light>);
}

TEST(Lights, the_key_light_of_old_scenes_is_refused_with_the_new_one) {
  const std::string message =
      error_of([] { scene_from_json(R"({"light": {"position": [1, 2, 3]}})", "scene.json"); });
  EXPECT_EQ(message,
            "light is not a known key; known here: mesh, texture, camera, lights, ambient, "
            "ambient_color, material, image");
}

TEST(Lights, each_has_exactly_one_kind) {
  EXPECT_THAT(refusal("[{}]"),
              HasSubstr("lights[0] must have exactly one of the keys point, directional, spot"));
  EXPECT_THAT(refusal(R"([{"point": {}}, {"point": {}, "spot": {}}])"), HasSubstr("lights[1]"));
  EXPECT_THAT(refusal(R"([{"lamp": {}}])"),
              HasSubstr("lights[0].lamp is not a known key; known here: point, directional, spot"));
}

TEST(Lights, a_key_of_another_kind_is_unknown) {
  EXPECT_THAT(refusal(R"([{"point": {"direction": [0, 0, 1]}}])"),
              HasSubstr("lights[0].point.direction is not a known key"));
  EXPECT_THAT(refusal(R"([{"directional": {"linear": 1}}])"),
              HasSubstr("lights[0].directional.linear is not a known key"));
}

TEST(Lights, numbers_out_of_range_are_named_by_the_light_s_path) {
  EXPECT_EQ(refusal(R"([{"point": {}}, {"point": {"intensity": -1}}])"),
            "lights[1].point.intensity must be >= 0, got -1");
  EXPECT_EQ(refusal(R"([{"point": {"quadratic": -0.5}}])"),
            "lights[0].point.quadratic must be >= 0, got -0.5");
  EXPECT_EQ(refusal(R"([{"spot": {"color": [0, 2, 0]}}])"),
            "lights[0].spot.color[1] must be <= 1, got 2");
  EXPECT_EQ(refusal(R"([{"spot": {"outer_degrees": 181}}])"),
            "lights[0].spot.outer_degrees must be <= 180, got 181");
}

TEST(Lights, a_direction_must_have_a_length) {
  for (const std::string kind : {"directional", "spot"}) {
    const auto with = [&](const std::string& v) {
      return refusal("[{\"" + kind + "\": {\"direction\": " + v + "}}]");
    };
    EXPECT_THAT(with("[0, 0, 0]"), HasSubstr("lights[0]." + kind + ".direction must be"));
    EXPECT_THAT(with("[0, 0, 0]"), HasSubstr("got [0, 0, 0]"));
    EXPECT_THAT(with("[1e-200, 0, 0]"), HasSubstr("direction"));  // its square underflows to 0
    EXPECT_THAT(with("[1e200, 0, 0]"), HasSubstr("direction"));
    EXPECT_EQ(with("[1e-99, 0, 0]"), "");
  }
}

TEST(Lights, a_falloff_must_not_be_all_zero) {
  for (const std::string kind : {"point", "spot"}) {
    const std::string message = refusal(R"([{"point": {}}, {")" + kind + R"(": {"constant": 0}}])");
    EXPECT_THAT(message, HasSubstr("lights[1]." + kind));
    EXPECT_THAT(message, HasSubstr("must not all be 0"));
    for (const std::string key : {"linear", "quadratic"}) {
      EXPECT_EQ(refusal("[{\"" + kind + R"(": {"constant": 0, ")" + key + "\": 0.5}}]"), "");
    }
  }
}

TEST(Lights, a_spot_s_outer_cone_holds_its_inner_one) {
  const auto cone = [](const std::string& inner, const std::string& outer) {
    return refusal(R"([{"spot": {"inner_degrees": )" + inner + R"(, "outer_degrees": )" + outer +
                   "}}]");
  };
  EXPECT_EQ(cone("0", "180"), "");
  EXPECT_EQ(cone("20", "20.5"), "");
  EXPECT_THAT(cone("20", "20"), HasSubstr("lights[0].spot.outer_degrees must be at least 0.1"));
  EXPECT_THAT(cone("30", "20"), HasSubstr("got 20 and 30"));
  for (const auto& [inner, outer] :
       {std::pair{"10", "10.1"}, {"20", "20.1"}, {"30", "30.1"}, {"44.9", "45"}}) {
    EXPECT_EQ(cone(inner, outer), "") << inner;  // though in double some are closer due to rounding
  }
  EXPECT_THAT(cone("10", "10.09"), HasSubstr("at least 0.1 more than inner_degrees, got 10.09"));
}

TEST(Lights, check_scene_finds_a_bad_light_behind_good_ones) {
  SceneSpec scene;
  scene.view.lights = unusual_lights();
  EXPECT_NO_THROW(check_scene(scene));
  scene.view.lights.push_back(DirectionalLight{{0, 0, 0}, {}});
  EXPECT_THAT(error_of([&] { check_scene(scene); }), HasSubstr("lights[3].directional.direction"));
}

}  // namespace
}  // namespace lumaknot
