#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/json.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string refusal(const std::string& text) {
  return error_of([&] { scene_from_json(text, "knot.json"); });
}

/// Input that must be refused, and the required parts of the message.
struct BadInput {
  std::string text, path, value, remedy;
};

void expect_refused(const std::vector<BadInput>& inputs) {
  for (const BadInput& bad : inputs) {
    SCOPED_TRACE(bad.text);
    const std::string message = refusal(bad.text);
    EXPECT_THAT(message, HasSubstr(bad.path));
    EXPECT_THAT(message, HasSubstr(bad.value));
    EXPECT_THAT(message, HasSubstr(bad.remedy));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

std::string knot(const std::string& fields) { return R"({"mesh": {"knot": {)" + fields + "}}}"; }

TEST(SceneErrors, an_unknown_key_is_named_with_its_path_and_the_known_ones) {
  expect_refused({
      {R"({"mehs": 1})", "mehs", "", "mesh"},
      {R"({"mesh": {"knots": {}}})", "mesh.knots", "", "knot, file"},
      {R"({"mesh": {"knot": {"radius": 1}}})", "mesh.knot.radius", "", "ring"},
      {R"({"texture": {"colour": [0, 0, 0]}})", "texture.colour", "", "color"},
      {R"({"camera": {"fov": 40}})", "camera.fov", "", "fov_degrees"},
      {R"({"lights": [{"point": {"colour": 1}}]})", "lights[0].point.colour", "", "color"},
      {R"({"material": {"colour": 1}})", "material.colour", "", "shininess"},
      {R"({"image": {"depth": 8}})", "image.depth", "", "width"},
      {R"({"": 1})", "", "", "mesh"},
  });
}

TEST(SceneErrors, a_value_of_the_wrong_type_is_quoted) {
  expect_refused({
      {R"([1, 2])", "the scene", "[1,2]", "object"},
      {R"(null)", "the scene", "null", "object"},
      {R"({"mesh": 3})", "mesh", "3", "object"},
      {R"({"mesh": {"knot": []}})", "mesh.knot", "[]", "object"},
      {R"({"mesh": {"file": 7}})", "mesh.file", "7", "file name"},
      {R"({"mesh": {"file": ""}})", "mesh.file", "\"\"", "file name"},
      {R"({"texture": {"file": null}})", "texture.file", "null", "file name"},
      {R"({"texture": {"builtin": "wood"}})", "texture.builtin", "wood", "bricks"},
      {R"({"texture": {"builtin": 1}})", "texture.builtin", "1", "bricks"},
      {R"({"texture": {"color": "red"}})", "texture.color", "red", "three numbers"},
      {R"({"texture": {"color": [0, 1]}})", "texture.color", "[0,1]", "three numbers"},
      {R"({"texture": {"color": [0, 1, 1, 1]}})", "texture.color", "[0,1,1,1]", "three numbers"},
      {R"({"camera": "here"})", "camera", "here", "object"},
      {R"({"camera": {"position": [0, "1", 2]}})", "camera.position", "\"1\"", "three numbers"},
      {R"({"lights": {"point": {}}})", "lights", "{\"point\":{}}", "a list"},
      {R"({"lights": [3]})", "lights[0]", "3", "object"},
      {R"({"ambient": "0.1"})", "ambient", "\"0.1\"", "number"},
      {R"({"ambient": true})", "ambient", "true", "number"},
      {R"({"material": {"space": "YIQ"}})", "material.space", "YIQ", "\"rgb\", \"yiq\""},
      {R"({"material": {"clamp": null}})", "material.clamp", "null", "table1"},
      {R"({"material": {"normal": "flat"}})", "material.normal", "flat", "interpolated"},
      {R"({"image": {"width": "720"}})", "image.width", "\"720\"", "integer"},
  });
}

TEST(SceneErrors, a_number_out_of_range_is_quoted_with_its_range) {
  expect_refused({
      {knot(R"("tube": 0)"), "mesh.knot.tube", "got 0", "> 0"},
      {knot(R"("tube": -0.5)"), "mesh.knot.tube", "got -0.5", "> 0"},
      {knot(R"("ring": 0)"), "mesh.knot.ring", "got 0", "> 0"},
      {knot(R"("winding": -1)"), "mesh.knot.winding", "got -1", "> 0"},
      {knot(R"("segments": 2)"), "mesh.knot.segments", "got 2", "from 3 to"},
      {knot(R"("sides": -3)"), "mesh.knot.sides", "got -3", "from 3 to"},
      {knot(R"("repeat_u": 0)"), "mesh.knot.repeat_u", "got 0", "from 1 to"},
      {knot(R"("repeat_v": 10001)"), "mesh.knot.repeat_v", "got 10001", "to 10000"},
      {knot(R"("p": 1001)"), "mesh.knot.p", "got 1001", "to 1000"},
      {R"({"texture": {"color": [0, 1.5, 0]}})", "texture.color[1]", "got 1.5", "<= 1"},
      {R"({"texture": {"color": [0, 0, -1e-9]}})", "texture.color[2]", "got -1e-09", ">= 0"},
      {R"({"camera": {"fov_degrees": 180}})", "camera.fov_degrees", "got 180", "< 180"},
      {R"({"camera": {"fov_degrees": 0}})", "camera.fov_degrees", "got 0", "> 0"},
      {R"({"ambient": -0.1})", "ambient", "got -0.1", ">= 0"},
      {R"({"material": {"shininess": -1}})", "material.shininess", "got -1", ">= 0"},
      {R"({"image": {"height": 0}})", "image.height", "got 0", "from 1 to"},
      {R"({"image": {"samples": 65}})", "image.samples", "got 65", "to 64"},
  });
}

TEST(SceneErrors, light_that_no_float_image_can_hold_is_refused) {
  expect_refused({
      {R"({"lights": [{"point": {"intensity": 1e39}}]})", "lights[0].point.intensity", "got 1e+39",
       "<= 1000000"},
      {R"({"lights": [{"spot": {"intensity": 1000001}}]})", "lights[0].spot.intensity",
       "got 1000001", "<= 1000000"},
      {R"({"lights": [{"directional": {"intensity": 1e39}}]})", "lights[0].directional.intensity",
       "got 1e+39", "<= 1000000"},
      {R"({"ambient": 1e39})", "ambient", "got 1e+39", "<= 1000000"},
      {R"({"material": {"diffuse": 1e39}})", "material.diffuse", "got 1e+39", "<= 1000000"},
      {R"({"material": {"specular": 1e39}})", "material.specular", "got 1e+39", "<= 1000000"},
      {R"({"material": {"space": "yiq", "luma_offset": 1e39}})", "material.luma_offset",
       "got 1e+39", "<= 1000000"},
      {R"({"material": {"space": "yiq", "luma_offset": -1e39}})", "material.luma_offset",
       "got -1e+39", ">= -1000000"},
  });
  EXPECT_EQ(refusal(R"({"lights": [{"point": {"intensity": 1000000}}]})"), "");
}

TEST(SceneErrors, numbers_that_are_not_integers_or_do_not_fit_an_int_are_refused) {
  expect_refused({
      {knot(R"("segments": 99999999999999999999)"), "mesh.knot.segments", "got", "integer"},
      {knot(R"("segments": 18446744073709551615)"), "mesh.knot.segments", "got", "integer"},
      {knot(R"("segments": 9223372036854775808)"), "mesh.knot.segments", "got", "integer"},
      {knot(R"("segments": -9223372036854775808)"), "mesh.knot.segments", "got -9", "integer"},
      {knot(R"("segments": 4294967299)"), "mesh.knot.segments", "got 4294967299", "integer"},
      {knot(R"("p": -99999999999999999999)"), "mesh.knot.p", "got", "integer"},
      {knot(R"("sides": 3.5)"), "mesh.knot.sides", "got 3.5", "integer"},
      {R"({"image": {"width": 720.25}})", "image.width", "got 720.25", "integer"},
  });
}

TEST(SceneErrors, a_huge_integer_is_quoted_as_it_was_written) {
  EXPECT_THAT(refusal(knot(R"("segments": 18446744073709551615)")),
              HasSubstr("18446744073709551615"));
}

TEST(SceneErrors, exactly_one_alternative_must_be_chosen) {
  expect_refused({
      {R"({"mesh": {}})", "mesh", "{}", "exactly one of the keys knot, file"},
      {R"({"mesh": {"knot": {}, "file": "a.obj"}})", "mesh", "a.obj", "exactly one"},
      {R"({"texture": {}})", "texture", "{}", "builtin, file, color"},
      {R"({"texture": {"builtin": "bricks", "color": [0, 0, 0]}})", "texture", "bricks",
       "exactly one"},
      {R"({"texture": {"file": "a.png", "color": [0, 0, 0]}})", "texture", "a.png", "exactly one"},
  });
}

TEST(SceneErrors, a_knot_must_be_valid) {
  expect_refused({
      {knot(R"("p": 0, "q": 0)"), "mesh.knot.p and mesh.knot.q", "0", "try"},
      {knot(R"("tube": 1.5)"), "mesh.knot.tube", "1.5", "mesh.knot.ring"},
      {knot(R"("convention": "max")"), "mesh.knot.convention", "max", "three"},
      {knot(R"("convention": "three", "winding": 0.4)"), "mesh.knot.winding", "0.4",
       "leave it out"},
  });
}

TEST(SceneErrors, a_camera_without_a_direction_is_refused) {
  expect_refused({
      {R"({"camera": {"up": [0, 0, 0]}})", "camera.up", "", "try"},
      {R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]}})", "camera.up", "", "try"},
      {R"({"camera": {"up": [0, 7.2, -4.8]}})", "camera.up", "", "try"},
      {R"({"camera": {"target": [0, -3.6, 2.4]}})", "camera.target", "", "differ"},
  });
}

TEST(SceneErrors, a_luma_offset_needs_a_luma_space) {
  expect_refused(
      {{R"({"material": {"luma_offset": -0.1}})", "material.luma_offset", "-0.1", "yiq"}});
  EXPECT_EQ(refusal(R"({"material": {"luma_offset": -0.1, "space": "yiq"}})"), "");
}

TEST(SceneErrors, an_unknown_choice_lists_the_valid_ones) {
  expect_refused({
      {R"({"material": {"model": "gouraud"}})", "material.model", "gouraud",
       R"(one of "phong", "blinn-phong", "minnaert", "oren-nayar", "cook-torrance")"},
      {R"({"material": {"model": 1}})", "material.model", "got 1", "phong"},
      {R"({"material": {"space": "hsv"}})", "material.space", "hsv",
       R"("rgb", "yiq", "yuv601", "yuv709", "cielab", "cieluv", "din99", "atd95")"},
      {R"({"material": {"form": "folded"}})", "material.form", "folded",
       R"("matrices", "collapsed", "baked")"},
      {R"({"material": {"gamut": "hue"}})", "material.gamut", "hue",
       R"("free", "clamp", "chroma")"},
      {R"({"material": {"highlights": true}})", "material.highlights", "true",
       R"("free", "gated")"},
      {R"({"material": {"rate": "texel"}})", "material.rate", "texel", R"("pixel", "vertex")"},
  });
}

/// A material with two fields set.
std::string material(const std::string& first, const std::string& second) {
  return R"({"material": {)" + first + ", " + second + "}}";
}

TEST(SceneErrors, a_form_without_matrices_needs_a_linear_space) {
  for (const std::string form : {"collapsed", "baked"}) {
    const std::string with_form = R"("form": ")" + form + '"';
    for (const std::string space : {"rgb", "cielab", "cieluv", "din99", "atd95"}) {
      expect_refused({{material(with_form, R"("space": ")" + space + '"'), "material.form", form,
                       "yiq, yuv601, yuv709"},
                      {material(with_form, R"("space": ")" + space + '"'), "", space, "matrices"}});
    }
    for (const std::string space : {"yiq", "yuv601", "yuv709"}) {
      EXPECT_EQ(refusal(material(with_form, R"("space": ")" + space + '"')), "");
    }
  }
}

TEST(SceneErrors, cook_torrance_cannot_be_a_mirror) {
  const std::string cook_torrance = R"("model": "cook-torrance")";
  expect_refused({{material(cook_torrance, R"("roughness": 0.039)"), "material.roughness",
                   "got 0.039", ">= 0.04"}});
  EXPECT_EQ(refusal(material(cook_torrance, R"("roughness": 0.04)")), "");
  EXPECT_EQ(refusal(material(R"("model": "oren-nayar")", R"("roughness": 0)")), "");
}

TEST(SceneErrors, a_material_s_numbers_out_of_range_are_quoted) {
  expect_refused({
      {R"({"material": {"roughness": 1.58}})", "material.roughness", "got 1.58", "<= 1.57"},
      {R"({"material": {"reflectance": 1.5}})", "material.reflectance", "got 1.5", "<= 1"},
      {R"({"material": {"darkness": -1}})", "material.darkness", "got -1", ">= 0"},
      {R"({"material": {"darkness": 11}})", "material.darkness", "got 11", "<= 10"},
      {R"({"material": {"diffuse_color": [0, 0, 2]}})", "material.diffuse_color[2]", "got 2",
       "<= 1"},
      {R"({"material": {"emissive": [-1, 0, 0]}})", "material.emissive[0]", "got -1", ">= 0"},
      {R"({"ambient_color": [0, 1.5, 0]})", "ambient_color[1]", "got 1.5", "<= 1"},
  });
}

TEST(SceneErrors, counts_are_multiplied_in_64_bits) {
  expect_refused({
      // 65536^2 is 2^32, which an int loses; the fields by themselves are in range.
      {R"({"image": {"width": 65536, "height": 65536}})", "image.width", "4294967296", "lower"},
      {R"({"image": {"width": 16384, "height": 16384, "samples": 64}})", "image.samples",
       "1099511627776", "lower"},
      {knot(R"("segments": 10000000, "sides": 1000000)"), "mesh.knot.segments", "10000011000001",
       "lower"},
  });
}

TEST(SceneErrors, text_that_is_not_json_is_refused_with_its_place) {
  for (const std::string text :
       {"", " ", "{", "{\"ambient\": 0.1", "{\"ambient\": NaN}", "{\"ambient\": Infinity}",
        "{\"ambient\": 0.1}}", "{'ambient': 0.1}", "{\"ambient\": .1}", "{\"a\": 1,}", "// c\n{}",
        "{\"ambient\":\n\n\"x", "\xff\xfe{}", "{\"mesh\": {\"file\": \"\xc3\x28\"}}"}) {
    SCOPED_TRACE(text);
    const std::string message = refusal(text);
    EXPECT_THAT(message, HasSubstr("knot.json is not JSON"));
    EXPECT_THAT(message, HasSubstr("line"));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

TEST(SceneErrors, every_truncation_of_a_scene_is_refused) {
  const std::string text = R"({"mesh": {"knot": {"p": 2}}, "image": {"width": 8}})";
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(refusal(text.substr(0, size)), "") << size;
  }
}

TEST(SceneErrors, a_number_beyond_the_doubles_is_named_with_its_place) {
  expect_refused({{R"({"ambient": 1e999})", "ambient", "1e999", ""}});
}

TEST(SceneErrors, a_key_with_control_characters_stays_on_one_line) {
  for (const char* text : {R"({"a\nb": 1})", R"({"a\rb": 1})", R"({"mesh": {"\u001b[31m": 1}})"}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "") << text;
    for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << text;
  }
}

TEST(SceneErrors, a_long_value_is_abbreviated) {
  const std::string message = refusal(R"({"ambient": ")" + std::string(10'000, 'x') + "\"}");
  EXPECT_THAT(message, HasSubstr("ambient"));
  EXPECT_LT(message.size(), 200u);  // a terminal's line or two
}

TEST(SceneErrors, a_key_given_twice_is_refused_or_the_last_one_counts) {
  const std::string text = R"({"ambient": 0.2, "ambient": 0.3})";
  if (refusal(text).empty()) {
    EXPECT_EQ(scene_from_json(text, "knot.json").view.ambient,
              0.3);  // as most do according to RFC 8259
  }
}

/// A list in a list in a list ...
std::string nested(std::size_t depth) {
  std::string text = "{\"ambient\": ";
  for (std::size_t i = 0; i < depth; ++i) text += '[';
  text.append(depth, ']');
  return text + "}";
}

TEST(SceneErrors, nested_json_is_refused_by_its_path) {
  expect_refused({{nested(50), "ambient", "[[[[", "a number"}});
}

TEST(SceneErrorsDeathTest, deeply_nested_json_is_refused_without_exhausting_the_stack) {
  const std::string text = nested(200'000);  // 400 kB
  EXPECT_EXIT(std::exit(refusal(text).empty() ? 1 : 0), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lumaknot
