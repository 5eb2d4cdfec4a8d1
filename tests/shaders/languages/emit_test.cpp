// Emitted shaders as text: complete, minimal, the same every time. What they compute is tested by
// running them, in tests/kernel.
#include "shaders/languages/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shaders/languages/common.h"
#include "system/error.h"
#include "tests/shaders/languages/emitted_text.h"

namespace lumaknot {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr Language kWithKernels[] = {Language::kGlsl330, Language::kGlslEs300, Language::kGlsl450,
                                     Language::kHlsl};

const std::vector<Light> kThreeLights{PointLight{}, DirectionalLight{}, SpotLight{}};

std::string label(const ShaderJob& job, Language language) {
  return std::string(backend_of(language).name) + " " + job.name + " " +
         (job.shot.material.rate == ShadingFrequency::kVertex ? "vertex" : "pixel");
}

/// Calls `check(job, language)` for every formula, rate and language: in turn with one light and
/// the numbers that the scene needs, and with lights of all kinds and every number a parameter.
/// What a language can't express is left out.
template <class F>
void for_each_emission(F check) {
  int index = 0;
  for (const std::string& formula : formula_names()) {
    const bool all = ++index % 2 > 0;  // five models in a row: each model and space has both
    ShaderJob job = all ? emission_job(formula, Keep::kAll, kThreeLights)
                        : emission_job(formula, Keep::kNeeded);
    for (const ShadingFrequency rate : {ShadingFrequency::kPixel, ShadingFrequency::kVertex}) {
      job.shot.material.rate = rate;
      for (const Language language : languages()) {
        if (!emission_shortfall(job, language)) check(job, language);
      }
    }
  }
}

TEST(Emit, kernels_hold_the_functions_of_the_emission_letter_for_letter) {
  for_each_emission([](const ShaderJob& job, Language language) {
    if (std::ranges::count(kWithKernels, language) == 0) return;
    const std::string emitted = emitted_text(job, language);
    const std::string kernel = emit_kernel(make_shader(job), language).fragment;
    const std::vector<std::string> functions = functions_of(kernel);
    ASSERT_GE(functions.size(), job.shot.material.rate == ShadingFrequency::kVertex ? 2u : 1u);
    for (const std::string& function : functions) {
      ASSERT_THAT(emitted, HasSubstr(function)) << label(job, language);
    }
  });
}

/// Declared whether or not the shader reads them: the block's matrices and what a mesh brings.
const std::set<std::string> kInterface{
    "world", "world_inverse_transpose", "position",     "normal", "uv",
    "World", "WorldInverseTranspose",   "vertex_normal"};

TEST(Emit, every_name_that_is_declared_is_used) {
  for_each_emission([](const ShaderJob& job, Language language) {
    if (language == Language::kBlender) return;
    const std::string code = code_of(emitted_text(job, language));
    const auto words = words_of(code);
    const std::set<std::string> declared = declared_names(code);
    ASSERT_FALSE(declared.empty()) << label(job, language);
    for (const std::string& name : declared) {
      if (kInterface.contains(name)) continue;
      // Both stages of Vulkan declare the whole block.
      const int min = language == Language::kGlsl450 ? 3 : 2;
      const bool is_parameter =
          std::ranges::count(make_shader(job).parameters, name, &ShaderParameter::name) > 0;
      ASSERT_GE(words.at(name), is_parameter ? min : 2) << name << ", " << label(job, language);
    }
  });
}

TEST(Emit, a_name_that_is_not_used_would_be_seen) {
  std::string code = code_of(emitted_text(emission_job("yiq-phong"), Language::kGlsl330));
  code.insert(code.rfind("  return"), "  float idle = 1.0; // idle\n");
  EXPECT_THAT(declared_names(code_of(code)), Contains("idle"));
  EXPECT_EQ(words_of(code_of(code)).at("idle"), 1);
}

TEST(Emit, every_parameter_is_declared_and_used_under_its_identifier) {
  for_each_emission([](const ShaderJob& job, Language language) {
    const Emission files = emit(job, language);
    const auto json = nlohmann::json::parse(files.back().text);
    const std::string text = emitted_text(job, language);
    const auto words = words_of(language == Language::kBlender ? text : code_of(text));
    for (const auto& parameter : json.at("parameters")) {
      const auto found = words.find(parameter.at("identifier").get<std::string>());
      ASSERT_NE(found, words.end()) << parameter << label(job, language);
      ASSERT_GE(found->second, 2) << parameter << label(job, language);
    }
  });
}

TEST(Emit, no_name_is_one_of_the_languages_words) {
  for (const Dialect* dialect : {&dialect_of(Language::kGlsl330), &dialect_of(Language::kHlsl),
                                 &dialect_of(Language::kFx), &dialect_of(Language::kOsl)}) {
    for (const std::string& formula : formula_names()) {
      const Shader shader = make_shader(emission_job(formula, Keep::kAll, kThreeLights));
      for (const ShaderParameter& p : shader.parameters) {
        const std::string name = parameter_identifier(p.name, *dialect);
        ASSERT_THAT(dialect->reserved, Not(Contains(name)));
      }
      for (const std::string& name :
           declared_names(function_text(color_function(shader), *dialect))) {
        ASSERT_THAT(dialect->reserved, Not(Contains(name)));
      }
    }
  }
}

TEST(Emit, of_a_scene_without_diffuse_light_holds_no_diffuse_code) {
  const SceneSpec scene = *builtin_scene("figure1-specular");
  const ShaderJob job{"figure1-specular",
                      scene.view,
                      {"final", Stage::kFinal, scene.view.material},
                      Keep::kNeeded,
                      std::nullopt};
  for (const Language language : languages()) {
    const std::string code = in_lower_case(code_of(emitted_text(job, language)));
    const std::string json = in_lower_case(emit(job, language).back().text);
    for (const std::string& text : {code, json}) {
      for (const char* diffuse : {"diffuse", "ambient", "max(n_dot_l", "saturate(n_dot_l"}) {
        EXPECT_THAT(text, Not(HasSubstr(diffuse))) << backend_of(language).name;
      }
    }
    EXPECT_THAT(in_lower_case(emitted_text(job, language)), HasSubstr("reflection"))
        << backend_of(language).name;
    EXPECT_THAT(json, HasSubstr("shininess")) << backend_of(language).name;
  }
}

TEST(Emit, nothing_loops) {
  for_each_emission([](const ShaderJob& job, Language language) {
    const auto words = words_of(code_of(emitted_text(job, language)));
    for (const char* word : {"for", "while", "do"}) {
      ASSERT_FALSE(words.contains(word)) << word << " " << label(job, language);
    }
  });
}

TEST(Emit, of_one_light_numbers_no_lights) {
  for (const Language language : languages()) {
    const std::string one = emitted_text(emission_job("yiq-phong"), language);
    EXPECT_THAT(in_lower_case(one), Not(HasSubstr("light1"))) << backend_of(language).name;
    const ShaderJob three = emission_job("yiq-phong", Keep::kAll, kThreeLights);
    EXPECT_THAT(in_lower_case(emitted_text(three, language)), HasSubstr("light3"));
  }
}

TEST(Emit, of_a_plain_colour_fetches_no_texture) {
  for (const std::string& formula : formula_names()) {
    ShaderJob job = emission_job(formula, Keep::kNeeded);
    job.color = Vec3d{0.7, 0.5, 0.25};
    for (const Language language : languages()) {
      const std::string code = in_lower_case(code_of(emitted_text(job, language)));
      for (const char* word :
           {"texture(", "uniform sampler", "samplerstate", "sampler_state", ".sample(", "tex2d",
            "color_texture", "texture_uv", "axes_texture", "texture_color"}) {
        ASSERT_THAT(code, Not(HasSubstr(word))) << formula << " " << backend_of(language).name;
      }
    }
  }
}

TEST(Emit, works_exactly_where_no_shortfall_is_told) {
  std::size_t emitted = 0, refused = 0;
  for (const std::string& formula : formula_names()) {
    for (const ShadingFrequency rate : {ShadingFrequency::kPixel, ShadingFrequency::kVertex}) {
      ShaderJob job = emission_job(formula);
      job.shot.material.rate = rate;
      for (const Language language : languages()) {
        const std::optional<std::string> why = emission_shortfall(job, language);
        const bool expected =
            rate == ShadingFrequency::kPixel || backend_of(language).has_vertex_stage;
        EXPECT_EQ(!why, expected) << label(job, language);
        if (!why) {
          EXPECT_EQ(emit(job, language).back().name, "parameters.json");
          ++emitted;
          continue;
        }
        EXPECT_THAT(*why, HasSubstr("nearest"));
        EXPECT_THROW(emit(job, language), Error) << label(job, language);
        ++refused;
      }
    }
  }
  EXPECT_EQ(emitted, 55u * (8 + 5));
  EXPECT_EQ(refused, 55u * 3);
}

TEST(Emit, more_lights_than_a_language_takes_are_a_shortfall) {
  for (const Light& light : {Light(PointLight{}), Light(SpotLight{})}) {
    for (std::size_t count = 1; count <= 16; ++count) {
      const ShaderJob job =
          emission_job("atd95-cook-torrance", Keep::kAll, std::vector<Light>(count, light));
      for (const Language language : languages()) {
        if (const auto why = emission_shortfall(job, language)) {
          EXPECT_THAT(*why, HasSubstr("fewer lights")) << backend_of(language).name;
          EXPECT_THROW(emit(job, language), Error) << backend_of(language).name << " " << count;
        } else {
          EXPECT_NO_THROW(emit(job, language)) << backend_of(language).name << " " << count;
        }
      }
    }
  }
}

TEST(Emit, twice_gives_the_same_bytes) {
  for_each_emission([](const ShaderJob& job, Language language) {
    const Emission once = emit(job, language), again = emit(job, language);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(once[i].name, again[i].name);
      ASSERT_EQ(once[i].text, again[i].text);
    }
  });
}

}  // namespace
}  // namespace lumaknot
