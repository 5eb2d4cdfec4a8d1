// What the recorder rejects, and the minima by which it decides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "shaders/graph/expression.h"
#include "tests/shaders/graph/evaluate.h"
#include "tests/shaders/graph/random_expression.h"

namespace lumaknot {
namespace {

constexpr double kUnknown = -std::numeric_limits<double>::infinity();

const Scalar kX = scalar_input("x");
const ScalarVec kU = vector_input("u"), kV = vector_input("v");

/// The recorder's message if it rejects; empty if it does not.
template <class F>
std::string refusal(F record) {
  try {
    record();
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return {};
}

TEST(Refused, is_a_quotient_by_zero) {
  EXPECT_THAT(refusal([] { return kX / 0; }), testing::HasSubstr("a quotient by zero"));
  EXPECT_NE(refusal([] { return Scalar(1) / (Scalar(2) - Scalar(2)); }), "");
  EXPECT_EQ(refusal([] { return kX / 1e-6; }), "");
  EXPECT_EQ(refusal([] { return Scalar(1) / kX; }), "");  // the formula's own affair
}

TEST(Refused, is_the_root_of_what_may_be_negative) {
  EXPECT_THAT(refusal([] { return sqrt(kX); }), testing::HasSubstr("root"));
  EXPECT_NE(refusal([] { return sqrt(Scalar(-1)); }), "");
  EXPECT_NE(refusal([] { return sqrt(abs(kX) - 1); }), "");
  EXPECT_EQ(refusal([] { return sqrt(Scalar(0)); }), "");
  EXPECT_EQ(refusal([] { return sqrt(kX * kX); }), "");
  EXPECT_EQ(refusal([] { return sqrt(dot(kU, kU)); }), "");
  EXPECT_EQ(refusal([] { return sqrt(max(kX, 0)); }), "");
}

TEST(Refused, is_the_power_of_what_may_be_negative) {
  EXPECT_THAT(refusal([] { return power(kX, 2); }), testing::HasSubstr("power"));
  EXPECT_NE(refusal([] { return power(kX, 1); }), "");  // before the 1 is seen
  EXPECT_NE(refusal([] { return power(dot(kU, kV), 3); }), "");
  EXPECT_EQ(refusal([] { return power(max(dot(kU, kV), 0), 3); }), "");
  EXPECT_EQ(refusal([] { return power(saturate(kX), kX); }), "");
}

TEST(Refused, is_the_logarithm_of_what_may_be_zero) {
  EXPECT_THAT(refusal([] { return log(abs(kX)); }), testing::HasSubstr("logarithm"));
  EXPECT_NE(refusal([] { return log(Scalar(0)); }), "");
  EXPECT_NE(refusal([] { return log(kX); }), "");
  EXPECT_EQ(refusal([] { return log(max(kX, 1e-3)); }), "");
  EXPECT_EQ(refusal([] { return log(abs(kX) + 1); }), "");
}

double min(const Scalar& s) { return s.node->min; }

TEST(LeastOf, is_the_value_of_a_number_and_unknown_of_what_is_read) {
  EXPECT_EQ(min(Scalar(-2.5)), -2.5);
  EXPECT_EQ(min(kX), kUnknown);
  EXPECT_EQ(min(scalar_parameter("p", 3)), kUnknown);  // a user may change it
  EXPECT_EQ(kU.node->min, kUnknown);
}

TEST(LeastOf, follows_the_operations) {
  const Scalar positive = abs(kX) + 2, negative = Scalar(0) - abs(kX);
  EXPECT_EQ(min(positive), 2);
  EXPECT_EQ(min(negative), kUnknown);
  EXPECT_EQ(min(positive + 1), 3);
  EXPECT_EQ(min(positive + negative), kUnknown);
  EXPECT_EQ(min(positive * positive), 0);  // a square, whatever its base
  EXPECT_EQ(min(positive * (abs(kX) + 3)), 6);
  EXPECT_EQ(min(positive * negative), kUnknown);
  EXPECT_EQ(min(Scalar(1) / positive), 0);
  EXPECT_EQ(min(max(negative, -3)), -3);
  EXPECT_EQ(min(min(positive, 1)), 1);
  EXPECT_EQ(min(min(positive, negative)), kUnknown);
  EXPECT_EQ(min(select_less(kX, 0, positive, Scalar(5))), 2);
  EXPECT_EQ(min(select_less(kX, 0, negative, positive)), kUnknown);
}

TEST(LeastOf, is_zero_for_what_is_never_negative) {
  for (const Scalar& s :
       {kX * kX, dot(kU, kU), abs(kX), exp(kX), saturate(kX), sqrt(abs(kX)), power(abs(kX), kX)}) {
    EXPECT_EQ(min(s), 0);
  }
  EXPECT_EQ(min(dot(kU, kV)), kUnknown);
}

TEST(LeastOf, is_never_above_what_a_graph_evaluates_to) {
  RandomGraph random(7);
  int known = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scalar graph = random.scalar(5);
    const double min_value = min(graph);
    known += min_value > kUnknown;
    for (int j = 0; j < 3; ++j) {
      // Rounding of a few operations on numbers up to 100.
      ASSERT_GE(evaluate(graph.node, random.inputs()).x, min_value - 1e-12) << i;
    }
  }
  EXPECT_GT(known, 500);
}

}  // namespace
}  // namespace lumaknot
