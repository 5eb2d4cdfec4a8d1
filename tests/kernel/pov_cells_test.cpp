// Every POV-Ray macro, run in POV-Ray against the formula in double.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/kernel_judge.h"
#include "tests/kernel/pov_kernel.h"

namespace lumaknot {
namespace {

using namespace testing;

class PovMacros : public ::testing::TestWithParam<std::string> {};

std::vector<PovInput> pov_inputs(const KernelRows& rows) {
  std::vector<PovInput> inputs;
  for (const KernelColumn& c : rows.columns()) inputs.push_back({c.name, c.is_vector, c.values});
  return inputs;
}

TEST_P(PovMacros, compute_what_the_formula_computes) {
  if (find_program("povray").empty()) GTEST_SKIP() << "povray is not here; apt-get install povray";
  for (const KernelCell& cell : cells_of(GetParam(), false)) {
    const Shader shader = make_shader(cell.job);
    const KernelRows rows = kernel_rows(cell.job);
    const std::vector<Vec3d> colors =
        run_pov_macro(emit_pov(shader), identifier_of(shader.function, kPovDialect),
                      pov_inputs(rows), kKernelRows);
    const Verdict verdict = judged(cell.job, rows, colors, Precision::kDouble);
    add_to_table("pov", cell, verdict);
    EXPECT_EQ(verdict.failure, "") << cell.formula << ", " << cell.variant << ", "
                                   << verdict.failures << " rows";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, PovMacros, ::testing::ValuesIn(space_uses()), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace lumaknot
