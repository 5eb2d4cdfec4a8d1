// A language and a renderer are a file each and a line in their list: these tests are linked with
// the program's libraries, the two toys, and lists that are a line longer.
#include <gmock/gmock.h>

#include "shaders/languages/emit.h"
#include "tests/validate/small_scene.h"
#include "validate/renderers/entry.h"
#include "validate/report/forms.h"
#include "validate/run.h"

namespace lumaknot {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

ShaderJob job_of(ShadingFrequency rate) {
  ShaderJob job;
  job.name = "yiq-minnaert";
  job.shot = {"final", Stage::kFinal, *with_formula(Material{}, job.name)};
  job.shot.material.rate = rate;
  return job;
}

TEST(ToyLanguage, is_known_by_its_name) {
  const auto toy = language_of("toy");
  ASSERT_TRUE(toy);
  EXPECT_EQ(languages().back(), *toy);
  EXPECT_EQ(backend_of(*toy).about, "a test");
}

TEST(ToyLanguage, is_emitted_in_its_own_words) {
  const Emission files = emit(job_of(ShadingFrequency::kPixel), *language_of("toy"));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "yiq-minnaert.toy");
  EXPECT_THAT(files[0].text, HasSubstr("fn yiq_minnaert(position: vec3f, normal: vec3f, "));
  EXPECT_THAT(files[0].text, HasSubstr("let n_dot_l: f32 = "));
  EXPECT_THAT(files[0].text, HasSubstr("fn safe_power(base: f32, exponent: f32) -> f32"));
  for (const char* word : {"float ", "vec3 ", "float3", "?"}) {
    EXPECT_THAT(files[0].text, Not(HasSubstr(word)));
  }
  EXPECT_THAT(files[1].text, HasSubstr(R"("language": "toy")"));
}

TEST(ToyLanguage, without_a_vertex_stage_refuses_light_at_vertices) {
  const auto why = emission_shortfall(job_of(ShadingFrequency::kVertex), *language_of("toy"));
  ASSERT_TRUE(why);
  EXPECT_THAT(*why, HasSubstr("toy has no vertex stage"));
}

TEST(ToyRenderer, is_drawn_when_asked_for_and_held_to_its_own_limits) {
  const ValidationJob job{testing::small_scene(8), {testing::final_shot("phong")}, {"toy"}, {}};
  const Validation validation = validate(job);
  ASSERT_EQ(validation.judgements.size(), 1u);
  EXPECT_EQ(validation.judgements[0].rendering.renderer, "Toy");
  EXPECT_EQ(validation.verdict, Verdict::kDiffered) << "it draws grey";
  EXPECT_THAT(report_json(validation, {}), HasSubstr(R"("reason": "a test")"));
}

TEST(ToyRenderer, brings_the_flag_of_its_program) {
  std::vector<std::string_view> flags;
  for (const ProgramInfo* program : renderer_programs()) flags.push_back(program->flag);
  EXPECT_THAT(flags, Contains("--toy"));
}

TEST(UnknownRenderer, has_no_other_renderers_limits) {
  EXPECT_THROW(renderer_entry("Toyota"), std::logic_error);
}

}  // namespace
}  // namespace lumaknot
