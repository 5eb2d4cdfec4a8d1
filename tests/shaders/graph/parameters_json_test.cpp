// parameters.json: what a program needs to know to set an emitted shader's numbers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/shaders/languages/emitted_text.h"

namespace lumaknot {
namespace {

using Json = nlohmann::json;

/// Far away, bright, sharp: beyond the range of sliders.
ShaderJob far_job(const std::string& formula) {
  ShaderJob job = emission_job(formula, Keep::kAll,
                               {PointLight{{-5000, 0, 20}, {{1, 1, 1}, 1e4}, {500, 0, 0}}});
  job.view.ambient = 3;
  job.shot.material.parameters["shininess"] = 1e5;
  job.shot.material.specular = 20;
  return job;
}

/// Every formula, in turn as the default scene needs it, with lights of all kinds, without a
/// texture, and with extreme numbers.
std::vector<ShaderJob> jobs() {
  std::vector<ShaderJob> list;
  for (const std::string& formula : formula_names()) {
    switch (list.size() % 4) {
      case 0:
        list.push_back(emission_job(formula, Keep::kNeeded));
        break;
      case 1:
        list.push_back(
            emission_job(formula, Keep::kAll, {PointLight{}, DirectionalLight{}, SpotLight{}}));
        break;
      case 2:
        list.push_back(emission_job(formula));
        list.back().color = Vec3d{0.2, 0.4, 0.9};
        break;
      default:
        list.push_back(far_job(formula));
    }
  }
  return list;
}

/// Calls `check(json, job, language)` for parameters.json of every emission.
template <class F>
void for_each_json(F check) {
  for (const ShaderJob& job : jobs()) {
    for (const Language language : languages()) {
      if (emission_shortfall(job, language)) continue;
      check(Json::parse(emit(job, language).back().text), job, language);
    }
  }
}

TEST(ParametersJson, tells_everything_about_every_parameter) {
  for_each_json([](const Json& json, const ShaderJob& job, Language language) {
    const Shader shader = make_shader(job);
    ASSERT_EQ(json.at("parameters").size(), shader.parameters.size());
    for (std::size_t i = 0; i < shader.parameters.size(); ++i) {
      const Json& p = json["parameters"][i];
      ASSERT_EQ(p.at("name"), shader.parameters[i].name);
      ASSERT_EQ(p.at("type"), shader.parameters[i].is_vector ? "vec3" : "float");
      for (const char* key : {"identifier", "unit", "meaning"}) {
        ASSERT_FALSE(p.at(key).get<std::string>().empty()) << p;
      }
      ASSERT_EQ(p.contains("offset"),
                language == Language::kGlsl450 || language == Language::kHlsl);
    }
  });
}

TEST(ParametersJson, names_the_files_beside_it) {
  for_each_json([](const Json& json, const ShaderJob& job, Language language) {
    const Emission files = emit(job, language);
    ASSERT_EQ(json.at("files").size() + 1, files.size());
    for (std::size_t i = 0; i + 1 < files.size(); ++i) ASSERT_EQ(json["files"][i], files[i].name);
    ASSERT_EQ(json.at("shader"), job.name);
    ASSERT_EQ(json.at("language"), backend_of(language).name);
  });
}

TEST(ParametersJson, defaults_are_the_scene_s_and_lie_in_their_range) {
  for_each_json([](const Json& json, const ShaderJob& job, Language) {
    const Shader shader = make_shader(job);
    for (std::size_t i = 0; i < shader.parameters.size(); ++i) {
      const Json& p = json["parameters"][i];
      const double min = p.at("range")[0], max = p.at("range")[1];
      ASSERT_LT(min, max);
      const Json values = p.at("type") == "vec3" ? p.at("default") : Json::array({p.at("default")});
      const auto expected = components(shader.parameters[i].value);
      for (std::size_t c = 0; c < values.size(); ++c) {
        ASSERT_EQ(values[c].get<double>(), expected[c]) << p;
        ASSERT_GE(values[c].get<double>(), min) << p;
        ASSERT_LE(values[c].get<double>(), max) << p;
      }
    }
  });
}

TEST(ParametersJson, offsets_are_those_of_std140) {
  for_each_json([](const Json& json, const ShaderJob&, Language) {
    int end = 3 * 64;  // three matrices
    for (const Json& p : json.at("parameters")) {
      if (!p.contains("offset")) return;
      const int offset = p["offset"], size = p["type"] == "vec3" ? 12 : 4;
      const int alignment = size == 12 ? 16 : 4;
      ASSERT_EQ(offset, (end + alignment - 1) / alignment * alignment) << p;
      // HLSL packs the same: no member crosses a boundary of 16 bytes.
      ASSERT_EQ(offset / 16, (offset + size - 1) / 16) << p;
      end = offset + size;
    }
  });
}

TEST(ParametersJson, identifiers_differ_from_each_other) {
  for_each_json([](const Json& json, const ShaderJob& job, Language) {
    std::set<std::string> names;
    for (const char* list : {"parameters", "inputs", "textures", "matrices"}) {
      if (!json.contains(list)) continue;
      for (const Json& entry : json[list]) {
        ASSERT_TRUE(names.insert(entry.at("identifier")).second) << entry << job.name;
      }
    }
  });
}

TEST(ParametersJson, texture_is_listed_where_one_is_read) {
  for_each_json([](const Json& json, const ShaderJob& job, Language language) {
    const bool is_input = !backend_of(language).has_vertex_stage;
    const bool textured = make_shader(job).textured();
    ASSERT_EQ(json.contains("textures"), textured && !is_input) << job.name;
  });
}

}  // namespace
}  // namespace lumaknot
