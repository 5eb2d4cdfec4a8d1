// Every emitted shader, run in its language against the formula in double. With the environment
// variable LUMAKNOT_KERNEL_TABLE=FILE the largest errors are added to that file.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <tuple>

#include "tests/kernel/cells.h"
#include "tests/kernel/judge.h"
#include "tests/kernel/run.h"

namespace lumaknot {
namespace {

using namespace testing;

/// All languages except effects, which tests/effects compiles: no program here runs them.
std::vector<Language> languages_run() {
  std::vector<Language> all(languages().begin(), languages().end());
  std::erase(all, Language::kFx);
  return all;
}

Kernel kernel_of(const KernelCell& cell, Language language) {
  const Shader shader = make_shader(cell.job);
  return {shader, kernel_code(shader, language), kernel_rows(cell.job)};
}

class Kernels : public ::testing::TestWithParam<std::tuple<Language, std::string>> {};

TEST_P(Kernels, compute_what_the_formula_computes) {
  const auto& [language, space_use] = GetParam();
  if (const std::string why = missing_for(language); !why.empty()) {
    if (is_extra(language)) GTEST_SKIP() << why;
    FAIL() << why;
  }
  const std::vector<KernelCell> cells = cells_of(space_use, backend_of(language).has_vertex_stage);
  std::vector<Kernel> kernels;
  for (const KernelCell& cell : cells) kernels.push_back(kernel_of(cell, language));
  const std::vector<Colors> colors = run_kernels(kernels, language);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Verdict verdict =
        judged(cells[i].job, kernels[i].rows, colors[i], precision_of(language));
    add_to_table(std::string(backend_of(language).name), cells[i], verdict);
    EXPECT_EQ(verdict.failure, "")
        << cells[i].formula << ", " << cells[i].variant << ": " << verdict.failures << " rows";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Kernels,
                         ::testing::Combine(::testing::ValuesIn(languages_run()),
                                            ::testing::ValuesIn(space_uses())),
                         [](const auto& p) {
                           return cell_test_name(std::get<0>(p.param), std::get<1>(p.param));
                         });

/// `code` with the first number that reads `constant` a thousandth larger.
std::string with_mutation(const std::string& code, const std::string& constant) {
  const std::regex number("([^0-9.])" + std::regex_replace(constant, std::regex("\\."), "\\.") +
                          "(?![0-9])");
  std::smatch match;
  if (!std::regex_search(code, match, number)) return code;
  return match.prefix().str() + match[1].str() + fmt::format("{}", std::stod(constant) * 1.001) +
         match.suffix().str();
}

struct Mutation {
  std::string formula, constant;
};

/// Constants of a model, of a linear space, and of a nonlinear one.
const std::vector<Mutation> kMutations{
    {"rgb-oren-nayar", "0.33"}, {"yiq-phong", "0.29889531"}, {"cielab-cook-torrance", "500.0"}};

class MutatedKernels : public ::testing::TestWithParam<Language> {};

TEST_P(MutatedKernels, with_a_constant_off_by_a_thousandth_are_caught) {
  if (const std::string why = missing_for(GetParam()); !why.empty()) {
    if (is_extra(GetParam())) GTEST_SKIP() << why;
    FAIL() << why;
  }
  std::vector<KernelCell> cells;
  std::vector<Kernel> kernels;
  for (const Mutation& mutation : kMutations) {
    cells.push_back(plain_cell(mutation.formula));
    kernels.push_back(kernel_of(cells.back(), GetParam()));
    const std::string unharmed = kernels.back().code;
    kernels.back().code = with_mutation(unharmed, mutation.constant);
    ASSERT_NE(kernels.back().code, unharmed) << mutation.formula;
  }
  const std::vector<Colors> colors = run_kernels(kernels, GetParam());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Verdict verdict =
        judged(cells[i].job, kernels[i].rows, colors[i], precision_of(GetParam()));
    EXPECT_GT(verdict.failures, kKernelRows / 100) << cells[i].formula;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, MutatedKernels, ::testing::ValuesIn(languages_run()),
                         [](const auto& p) { return cell_test_name(p.param, "mutated"); });

}  // namespace
}  // namespace lumaknot
