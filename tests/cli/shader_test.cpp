// `lumaknot shader` as a user sees it.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/presets.h"
#include "shaders/languages/emit.h"
#include "system/error.h"
#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using ShaderCommand = Program;

TEST_F(ShaderCommand, writes_both_stages_and_the_parameters) {
  const ProcessResult result = lumaknot({"shader", "yiq-phong", "--lang", "glsl-330", "-o", "out"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_TRUE(fs::exists(path("out/yiq-phong.vert")));
  EXPECT_THAT(read("out/yiq-phong.frag"), HasSubstr("#version 330 core"));
  const auto json = nlohmann::json::parse(read("out/parameters.json"));
  for (const auto& parameter : json["parameters"]) {
    for (const char* key : {"name", "identifier", "type", "default", "range", "unit", "meaning"}) {
      EXPECT_TRUE(parameter.contains(key)) << key << " of " << parameter;
    }
  }
}

TEST_F(ShaderCommand, writes_each_of_several_languages_to_its_own_folder) {
  EXPECT_THAT(lumaknot({"shader", "yiq-phong", "-o", "out"}), ExitsWith(0));
  for (const Language language : languages()) {
    EXPECT_TRUE(fs::exists(path("out") / backend_of(language).name / "parameters.json"))
        << backend_of(language).name;
  }
  EXPECT_TRUE(fs::exists(path("out/blender/lumaknot_nodes.py"))) << "the loader of the recipe";
}

TEST_F(ShaderCommand, emits_only_what_a_scene_needs) {
  write("plain.json", R"({"texture": {"color": [0.2, 0.4, 0.6]},
                          "material": {"space": "yiq", "specular": 0}})");
  EXPECT_THAT(lumaknot({"shader", "--scene", "plain.json", "--lang", "glsl-330"}), ExitsWith(0));
  const std::string text = read("plain.frag");
  for (const char* absent :
       {"texture(", "sampler2D", "specular", "shininess", "reflection", "for ("}) {
    EXPECT_THAT(text, Not(HasSubstr(absent)));
  }
}

TEST_F(ShaderCommand, keeps_every_number_on_request) {
  EXPECT_THAT(lumaknot({"shader", "rgb-phong", "--lang", "hlsl", "--all-parameters"}),
              ExitsWith(0));
  const std::string text = read("rgb-phong.hlsl");
  for (const char* name : {"light_color", "light_quadratic", "emissive", "diffuse"}) {
    EXPECT_THAT(text, HasSubstr(name));
  }
}

TEST_F(ShaderCommand, refuses_unknown_names_and_lists_the_valid_ones) {
  expect_refused({"shader", "yiq-fong"}, "cook-torrance");
  expect_refused({"shader", "hsv-phong"}, "cielab");
  expect_refused({"shader", "yiq-phong", "--lang", "glsl-120"}, "glsl-330");
  expect_refused({"shader", "yiq-phong", "--light", "area"}, "directional");
  expect_refused({"shader", "yiq-phong", "--name", "Yiq Phong"}, "--name");
  expect_refused({"shader", "yiq-phong", "--scene", "figure2"}, "not both");
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(ShaderCommand, reports_the_missing_feature_and_the_nearest_alternative) {
  for (const char* language : {"osl", "blender", "pov"}) {
    expect_refused({"shader", "yiq-phong", "--rate", "vertex", "--lang", language, "-o", "out"},
                   "the nearest is rate \"pixel\"");
  }
  write("vertex.json", R"({"material": {"rate": "vertex"}})");
  expect_refused({"shader", "--scene", "vertex.json", "--lang", "osl"}, "no vertex stage");
  EXPECT_EQ(files(), std::vector<std::string>{"vertex.json"});
}

TEST_F(ShaderCommand, skips_and_reports_languages_of_all_that_cannot_express_the_shader) {
  const ProcessResult result = lumaknot({"shader", "yiq-phong", "--rate", "vertex", "-o", "out"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log, HasSubstr("osl has no vertex stage"));
  EXPECT_FALSE(fs::exists(path("out/osl")));
  EXPECT_TRUE(fs::exists(path("out/fx")));
}

TEST_F(ShaderCommand, emits_the_same_bytes_twice) {
  for (const char* folder : {"one", "two"}) {
    EXPECT_THAT(lumaknot({"shader", "atd95-cook-torrance", "-o", folder}), ExitsWith(0));
  }
  for (const auto& entry : fs::recursive_directory_iterator(path("one"))) {
    if (!entry.is_regular_file()) continue;
    const fs::path relative = fs::relative(entry.path(), path("one"));
    EXPECT_EQ(read_file(entry.path(), "one"), read("two" / relative)) << relative;
  }
}

// --list, the documentation and what emit() does are one matrix.
TEST_F(ShaderCommand, list_and_documentation_agree) {
  const std::string list = lumaknot({"shader", "--list"}).log;
  const std::string page = read_file(fs::path(LUMAKNOT_SOURCE_DIR) / "docs/shaders.md", "docs");
  EXPECT_THAT(page, HasSubstr(list)) << "lumaknot shader --list > into docs/shaders.md";
}

TEST_F(ShaderCommand, list_and_emission_agree) {
  const auto list = nlohmann::json::parse(lumaknot({"shader", "--list", "--json"}).log);
  EXPECT_EQ(list.size(), formula_names().size() * 2);
  for (const auto& entry : list) {
    ShaderJob job;
    job.name = entry["shader"];
    job.shot = {"final", Stage::kFinal, *with_formula(job.view.material, job.name)};
    job.shot.material.rate =
        entry["rate"] == "vertex" ? ShadingFrequency::kVertex : ShadingFrequency::kPixel;
    EXPECT_EQ(entry["languages"].size() + entry["impossible"].size(), languages().size());
    for (const std::string name : entry["languages"]) {
      EXPECT_GE(emit(job, *language_of(name)).size(), 2u) << entry;
    }
    for (const auto& [name, why] : entry["impossible"].items()) {
      EXPECT_THROW(emit(job, *language_of(name)), Error) << entry;
      EXPECT_THAT(why.get<std::string>(), HasSubstr("nearest"));
    }
  }
}

}  // namespace
}  // namespace lumaknot::cli
