// Printed formulas, compiled and run, match the graph.
#include <gtest/gtest.h>

#include "tests/shaders/graph/random_expression.h"
#include "tests/shaders/languages/cpp_program.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// A formula, its inputs, and where it comes from.
struct Case {
  NodePtr root;
  Inputs inputs;
  std::string name;
};

/// Compiles and runs all cases as one program.
void expect_same_values(const std::vector<Case>& cases) {
  CppProgram program;
  for (const Case& c : cases) program.add(c.root, c.inputs);
  const std::vector<Vec3d> found = program.run();
  ASSERT_EQ(found.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Vec3d expected = evaluate(cases[i].root, cases[i].inputs);
    ASSERT_TRUE(is_finite(expected)) << cases[i].name;
    // The same operations of the same library in the same order.
    EXPECT_EQ(found[i], expected) << cases[i].name << "\n"
                                  << print_code({cases[i].root}, kCppDialect, "  ").statements
                                  << print_code({cases[i].root}, kCppDialect, "  ").results[0];
  }
}

TEST(PrintedCode, of_random_formulas_computes_what_their_graphs_do) {
  RandomGraph random(20260102);
  std::vector<Case> cases;
  for (int i = 0; i < 1000; ++i) {
    const int depth = 1 + i % 6;
    const NodePtr root = i % 2 ? random.vector(depth).node : random.scalar(depth).node;
    cases.push_back({root, random.inputs(), std::to_string(i)});
  }
  expect_same_values(cases);
}

TEST(PrintedCode, of_lighting_formulas_computes_what_their_graphs_do) {
  RandomSurface random;
  std::vector<Case> cases;
  const View view = every_view().back().view;
  for (const Shot& shot : final_shots()) {
    if (shot.material.gamut == Gamut::kClamp) continue;  // one more saturate than free
    const Inputs inputs = surface_inputs(random.point(), random.texture(), shot.material);
    cases.push_back({record_shot(view, shot).color, inputs, shot.name});
  }
  expect_same_values(cases);
}

}  // namespace
}  // namespace lumaknot
