// The functions of each language, run one by one: they meet the error models on which bounds are
// based.
#include "tests/kernel/error_models.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/kernel/cells.h"
#include "tests/kernel/judge.h"
#include "tests/kernel/run.h"
#include "tests/shaders/formulas/random_surface.h"

namespace lumaknot {
namespace {

using namespace testing;

/// A function of the operands a and b, and its largest error according to the models.
struct Function {
  std::string name;
  std::function<Scalar(const Scalar& a, const Scalar& b)> recorded;
  std::function<double(double a, double b)> exact;
  std::function<Vec3d(RandomSurface&)> operands;  ///< in x and y
};

double log_uniform(RandomSurface& random, double min, double max) {
  return std::exp(random.number(std::log(min), std::log(max)));
}

/// A base and an exponent whose power is far from the ends of float.
Vec3d power_operands(RandomSurface& random) {
  const double base = log_uniform(random, 1e-4, 10);
  const double max = 60 / std::max(std::abs(std::log(base)), 0.05);
  return {base, log_uniform(random, 0.01, max), 0};
}

const std::vector<Function>& functions() {
  static const std::vector<Function> kFunctions{
      {"power", [](auto& a, auto& b) { return power(abs(a), b); },
       [](double a, double b) { return std::pow(a, b); }, power_operands},
      {"exp", [](auto& a, auto&) { return exp(a); }, [](double a, double) { return std::exp(a); },
       [](RandomSurface& r) { return Vec3d{r.number(-20, 20), 0, 0}; }},
      {"log", [](auto& a, auto&) { return log(max(a, Scalar(1e-9))); },
       [](double a, double) { return std::log(a); },
       [](RandomSurface& r) { return Vec3d{log_uniform(r, 1e-6, 100), 0, 0}; }},
      {"sqrt", [](auto& a, auto&) { return sqrt(abs(a)); },
       [](double a, double) { return std::sqrt(a); },
       [](RandomSurface& r) { return Vec3d{log_uniform(r, 1e-12, 1e6), 0, 0}; }},
      {"division", [](auto& a, auto& b) { return a / b; }, [](double a, double b) { return a / b; },
       [](RandomSurface& r) { return Vec3d{r.number(-2, 2), log_uniform(r, 1e-6, 1e6), 0}; }},
      {"unit", [](auto& a, auto& b) { return x_of(unit(make_vec(a, b, b))); },
       [](double a, double b) { return a / std::sqrt(a * a + 2 * b * b); },
       [](RandomSurface& r) {
         return Vec3d{r.number(-1, 1), r.number(-1, 1), 0} * log_uniform(r, 1e-3, 1e3);
       }},
  };
  return kFunctions;
}

/// How far from `exact` a result may be.
template <class Errors>
double allowed(const std::string& name, const Vec3d& operands, double exact) {
  const double size = std::abs(exact);
  if (name == "power") return size * Errors::power(operands.x, operands.y);
  if (name == "exp") return size * Errors::exponential(operands.x);
  if (name == "log") return Errors::logarithm(operands.x);
  if (name == "sqrt") return size * Errors::root();
  if (name == "division") return size * Errors::division();
  return size * (1.5 * Errors::kRounding + Errors::root() + Errors::division());
}

double allowed(Precision precision, const std::string& name, const Vec3d& operands, double exact) {
  switch (precision) {
    case Precision::kCycles:
      return allowed<CyclesErrors>(name, operands, exact);
    case Precision::kVulkan:
      return allowed<rounding::VulkanErrors>(name, operands, exact);
    case Precision::kOsl:
      return allowed<OslErrors>(name, operands, exact);
    case Precision::kDouble:
      break;
  }
  return 0;
}

/// A shader that is one function of the position's x and y.
Shader shader_of(const Function& function) {
  Shader shader;
  shader.name = shader.function = "function_" + function.name;
  const ScalarVec position = vector_input("position");
  shader.recorded.color = grey(function.recorded(x_of(position), y_of(position))).node;
  shader.fragment.position = true;
  return shader;
}

KernelRows rows_of(const Function& function) {
  RandomSurface random;
  std::vector<KernelColumn> columns{
      {"position", true, {}}, {"normal", true, {}}, {"texture", true, {}}};
  for (std::size_t row = 0; row < kKernelRows; ++row) {
    const Vec3d v = function.operands(random);
    columns[0].values.push_back({float(v.x), float(v.y), 0});
    for (const std::size_t unused : {1, 2}) columns[unused].values.push_back({});
  }
  return KernelRows(std::move(columns));
}

/// Expects `found` within the model.
void expect_model(const Function& function, const KernelRows& rows, const Colors& found,
                  Precision precision) {
  double max = 0;
  for (std::size_t row = 0; row < kKernelRows; ++row) {
    const Vec3d operands = rows.columns()[0].values[row];
    const double exact = function.exact(operands.x, operands.y);
    const double error = std::abs(found.at(row).x - exact);
    const double limit = allowed(precision, function.name, operands, exact);
    max = std::max(max, error / limit);
    ASSERT_LE(error, limit) << function.name << " of " << operands.x << ", " << operands.y << ": "
                            << found[row].x << " in place of " << exact;
  }
  ::testing::Test::RecordProperty(function.name + "_percent_of_model", int(max * 100));
}

class Functions : public ::testing::TestWithParam<Language> {};

TEST_P(Functions, keep_the_error_model_of_their_language) {
  if (const std::string why = missing_for(GetParam()); !why.empty()) {
    if (is_extra(GetParam())) GTEST_SKIP() << why;
    FAIL() << why;
  }
  std::vector<Kernel> kernels;
  for (const Function& f : functions()) {
    const Shader shader = shader_of(f);
    kernels.push_back({shader, kernel_code(shader, GetParam()), rows_of(f)});
  }
  const std::vector<Colors> found = run_kernels(kernels, GetParam());
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    expect_model(functions()[i], kernels[i].rows, found[i], precision_of(GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Functions,
                         ::testing::Values(Language::kGlsl330, Language::kGlslEs300,
                                           Language::kGlsl450, Language::kHlsl, Language::kBlender,
                                           Language::kOsl),
                         [](const auto& p) { return cell_test_name(p.param, "functions"); });

}  // namespace
}  // namespace lumaknot
