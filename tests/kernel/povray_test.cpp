// Emitted POV-Ray macros, run in POV-Ray on random rows against the same formula in double.
#include "tests/kernel/povray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "scene/presets.h"
#include "shaders/formulas/lighting.h"
#include "system/error.h"
#include "tests/kernel/run.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using testing::kernel_code;
using testing::PovInput;

constexpr std::size_t kRows = 4096;

bool has_povray() { return !find_program("povray").empty(); }
constexpr const char* kNoPovRay = "povray not found; install with apt-get install povray";

/// Numbers from one seed, the same on every machine.
class Random {
 public:
  double number(double low, double high) {
    return low + (high - low) * (double(generator_()) / 4294967296.0);
  }
  Vec3d vector(double low, double high) {
    const double x = number(low, high), y = number(low, high);
    return {x, y, number(low, high)};
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v = vector(-1, 1);
      if (length(v) > 0.1 && length(v) <= 1) return normalize(v);
    }
  }

 private:
  std::mt19937 generator_{20260101};
};

Vec3d random_value(Random& random, const std::string& name, const Material& material) {
  const auto has = [&](std::string_view part) { return name.find(part) != name.npos; };
  if (name == "position") return random.vector(-1, 1);
  if (name == "normal") return random.direction() * random.number(0.9, 1);  // as interpolated
  if (name == "texture") return texture_value(random.vector(0, 1), material);
  if (has("direction")) return random.direction();
  if (has("_position")) return random.direction() * random.number(3, 6);
  if (name == "shininess") return {random.number(0, 60), 0, 0};
  if (has("cone_scale")) return {random.number(1, 20), 0, 0};
  if (name == "roughness") return {random.number(0.2, 1.5), 0, 0};
  if (name == "luma_offset") return {random.number(-0.2, 0.2), 0, 0};
  return random.vector(0, 1);
}

std::vector<PovInput> random_inputs(const Shader& shader, const Material& material) {
  std::vector<PovInput> inputs{{"position", true, {}}, {"normal", true, {}}, {"texture", true, {}}};
  for (const ShaderParameter& p : shader.parameters) inputs.push_back({p.name, p.is_vector, {}});
  Random random;
  for (PovInput& input : inputs) {
    for (std::size_t row = 0; row < kRows; ++row) {
      input.values.push_back(random_value(random, input.name, material));
    }
  }
  return inputs;
}

/// Gives the formula one row's values by name.
struct Row {
  const std::vector<PovInput>& inputs;
  std::size_t index;

  double number(const std::string& name, double value) const {
    const auto found = std::ranges::find(inputs, name, &PovInput::name);
    return found == inputs.end() ? value : found->values[index].x;
  }
  Vec3d vector(const std::string& name, const Vec3d& value) const {
    const auto found = std::ranges::find(inputs, name, &PovInput::name);
    return found == inputs.end() ? value : found->values[index];
  }
  Vec3d color(const std::string& name, const Vec3d& value) const { return vector(name, value); }
};

Vec3d expected(const ShaderJob& job, const Row& row) {
  const Lighting<double> lighting = lighting_of<double>(job.view, job.shot.material, row);
  return stage_color<double>({row.vector("position", {}), row.vector("normal", {})},
                             row.vector("texture", {}), lighting, job.shot);
}

ShaderJob job_of(std::string_view formula, std::vector<Light> lights = {PointLight{}}) {
  ShaderJob job;
  job.name = formula;
  job.view.lights = std::move(lights);
  job.shot = {"final", Stage::kFinal, *with_formula(Material{}, formula)};
  job.keep = Keep::kAll;
  return job;
}

/// The largest difference of a channel over all rows, relative to colours beyond 1.
double largest_error(const ShaderJob& job, const std::vector<PovInput>& inputs) {
  const Shader shader = make_shader(job);
  const std::size_t rows = inputs[0].values.size();
  const std::vector<Vec3d> colors = testing::run_pov_macro(
      kernel_code(shader, Language::kPov),
      identifier_of(shader.function, dialect_of(Language::kPov)), inputs, rows);
  double largest = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (!is_finite(colors[i])) return std::numeric_limits<double>::infinity();
    const Vec3d mine = expected(job, {inputs, i});
    const Vec3d apart = colors[i] - mine;
    const double error = largest_magnitude(apart);
    largest = std::max(largest, error / std::max(1.0, length(mine)));
  }
  return largest;
}

double largest_error(const ShaderJob& job) {
  return largest_error(job, random_inputs(make_shader(job), job.shot.material));
}

/// Both compute in double, the same operations in the same order. Where POV-Ray shares our libm the
/// difference is that of 17 printed decimals, 7e-18. Another libm's pow may be off by an ulp, which
/// exponents up to 60 and the roots of the spaces enlarge.
constexpr double kDouble = 1e-12;

class PovMacro : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!has_povray()) FAIL() << kNoPovRay;
  }
};

TEST_P(PovMacro, computes_the_formula_in_double) {
  EXPECT_LE(largest_error(job_of(GetParam())), kDouble);
}

INSTANTIATE_TEST_SUITE_P(Formulas, PovMacro,
                         ::testing::Values("rgb-phong", "yiq-table1-minnaert",
                                           "yiq-collapsed-oren-nayar", "yiq-baked-cook-torrance",
                                           "yuv709-blinn-phong", "cielab-phong",
                                           "cieluv-blinn-phong", "din99-cook-torrance",
                                           "atd95-oren-nayar"),
                         [](const auto& p) {
                           std::string name(p.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

class PovMacroWith : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_povray()) FAIL() << kNoPovRay;
  }
};

TEST_F(PovMacroWith, lights_of_every_kind_computes_the_formula) {
  for (const char* formula : {"rgb-blinn-phong", "yiq-phong"}) {
    const ShaderJob job = job_of(formula, {PointLight{}, DirectionalLight{}, SpotLight{}});
    EXPECT_LE(largest_error(job), kDouble) << formula;
  }
}

TEST_F(PovMacroWith, gated_highlights_and_the_rule_for_the_gamut_computes_the_formula) {
  for (const char* formula : {"rgb-phong", "cielab-cook-torrance"}) {
    ShaderJob job = job_of(formula);
    job.shot.material.highlights = Highlights::kGated;
    job.shot.material.gamut = Gamut::kChroma;
    EXPECT_LE(largest_error(job), kDouble) << formula;
  }
}

TEST_F(PovMacroWith, values_that_languages_leave_open_computes_the_formula) {
  // 0 to the power 0, unit vectors of zero: no normal, a light and an eye at the point itself.
  const ShaderJob job = job_of("rgb-phong");
  std::vector<PovInput> inputs = random_inputs(make_shader(job), job.shot.material);
  for (PovInput& input : inputs) {
    input.values.resize(8);
    for (std::size_t row = 0; row < 8; ++row) {
      const bool is_zero = (input.name == "shininess" && row % 2) ||
                           (input.name == "normal" && row / 2 % 2) ||
                           (input.name != "texture" && input.is_vector && row >= 4);
      if (is_zero) input.values[row] = {};
    }
  }
  EXPECT_LE(largest_error(job, inputs), kDouble);
}

/// The scene in the comment at the head of an include file.
std::string example_in(const std::string& include) {
  std::istringstream stream(include);
  const std::string margin = "//   ";
  std::string scene;
  for (std::string line; std::getline(stream, line) && line.starts_with("//");) {
    if (line.starts_with(margin)) scene += line.substr(margin.size()) + "\n";
  }
  return scene;
}

TEST_F(PovMacroWith, the_example_in_its_comment_draws_a_picture) {
  for (const char* formula : {"yiq-phong", "yiq-baked-phong", "rgb-cook-torrance"}) {
    const std::string include = kernel_code(make_shader(job_of(formula)), Language::kPov);
    const PrivateFolder folder;
    write_file(folder.path() / fmt::format("{}.inc", formula), include, "test");
    write_file(folder.path() / "example.pov", example_in(include), "test");
    const ProcessResult ended = run(
        {{find_program("povray").string(), "+Iexample.pov", "+Oexample.png", "-D", "+W32", "+H32"},
         folder.path(),
         {}},
        std::chrono::seconds(60));
    EXPECT_TRUE(ended.succeeded()) << ended.log;
    EXPECT_THAT(ended.log, ::testing::Not(HasSubstr("Parse Warning"))) << ended.log;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "example.png"));
  }
}

TEST(EmitPov, parameters_are_the_surface_then_what_the_scene_needs) {
  ShaderJob job = job_of("yiq-phong");
  job.keep = Keep::kNeeded;
  EXPECT_THAT(testing::pov_parameters(kernel_code(make_shader(job), Language::kPov), "Yiq_Phong"),
              ::testing::ElementsAre("Position", "Normal", "Texture_Color", "Light_Position",
                                     "Eye_Position", "Ambient", "Shininess"));
}

TEST(EmitPov, includes_the_helpers_that_it_calls_alone) {
  ShaderJob job = job_of("rgb-phong");
  job.keep = Keep::kNeeded;
  job.shot.material.specular = 0;
  const std::string matte = kernel_code(make_shader(job), Language::kPov);
  EXPECT_THAT(matte, HasSubstr("#macro Lumaknot_Normalize("));
  EXPECT_THAT(matte, ::testing::Not(HasSubstr("Lumaknot_Power")));
  EXPECT_THAT(matte, ::testing::Not(HasSubstr("Lumaknot_Saturate")));
  job.shot.material.gamut = Gamut::kClamp;
  EXPECT_THAT(kernel_code(make_shader(job), Language::kPov),
              HasSubstr("#macro Lumaknot_Saturate("));
}

TEST(EmitPov, more_parameters_than_a_macro_takes_are_refused) {
  const std::vector<Light> lights(8, SpotLight{});
  try {
    emit(job_of("rgb-phong", lights), Language::kPov);
    FAIL() << "POV-Ray rejects such a macro";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("at most 55; nearest: fewer lights"));
  }
}

TEST_F(PovMacroWith, as_many_parameters_as_allowed_computes_the_formula) {
  std::vector<Light> lights(5, SpotLight{});
  lights.resize(8, DirectionalLight{});
  const ShaderJob job = job_of("rgb-phong", lights);
  const std::string include = kernel_code(make_shader(job), Language::kPov);
  ASSERT_EQ(testing::pov_parameters(include, "Rgb_Phong").size(), 55u);
  EXPECT_LE(largest_error(job), kDouble);
}

}  // namespace
}  // namespace lumaknot
