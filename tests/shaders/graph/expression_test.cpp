// What the recorder evaluates at once, and what it keeps.
#include "shaders/graph/expression.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/shaders/graph/evaluate.h"

namespace lumaknot {
namespace {

const Scalar kX = scalar_input("x"), kY = scalar_input("y");
const ScalarVec kU = vector_input("u"), kV = vector_input("v");

bool is(const Scalar& a, const Scalar& b) { return a.node == b.node; }
bool is(const ScalarVec& a, const ScalarVec& b) { return a.node == b.node; }

bool is_number(const Scalar& s, double value) {
  return s.node->op == Op::kConstant && !s.node->is_vector && s.node->value.x == value;
}

bool is_vector_constant(const ScalarVec& v, const Vec3d& value) {
  return v.node->op == Op::kConstant && v.node->is_vector && v.node->value == value;
}

/// A step on scalars with these arguments.
bool is_step(const Scalar& s, Op op, const std::vector<NodePtr>& arguments) {
  return s.node->op == op && !s.node->is_vector && s.node->arguments == arguments;
}

bool is_step(const ScalarVec& v, Op op, const std::vector<NodePtr>& arguments) {
  return v.node->op == op && v.node->is_vector && v.node->arguments == arguments;
}

TEST(Expression, steps_keep_their_arguments_in_order) {
  EXPECT_TRUE(is_step(kX + kY, Op::kAdd, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(kX - kY, Op::kSubtract, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(kX * kY, Op::kMultiply, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(kX / kY, Op::kDivide, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(max(kX, kY), Op::kMaximum, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(min(kX, kY), Op::kMinimum, {kX.node, kY.node}));
  EXPECT_TRUE(is_step(abs(kX), Op::kAbs, {kX.node}));
  EXPECT_TRUE(is_step(exp(kX), Op::kExp, {kX.node}));
  EXPECT_TRUE(is_step(saturate(kX), Op::kSaturate, {kX.node}));
  EXPECT_TRUE(
      is_step(select_less(kX, kY, kY, kX), Op::kSelectLess, {kX.node, kY.node, kY.node, kX.node}));
}

TEST(Expression, steps_on_vectors_keep_their_arguments_in_order) {
  EXPECT_TRUE(is_step(kU + kV, Op::kAdd, {kU.node, kV.node}));
  EXPECT_TRUE(is_step(kU - kV, Op::kSubtract, {kU.node, kV.node}));
  EXPECT_TRUE(is_step(modulate(kU, kV), Op::kMultiply, {kU.node, kV.node}));
  EXPECT_TRUE(is_step(kU * kX, Op::kScale, {kU.node, kX.node}));
  EXPECT_TRUE(is_step(dot(kU, kV), Op::kDot, {kU.node, kV.node}));
  EXPECT_TRUE(is_step(cross(kU, kV), Op::kCross, {kU.node, kV.node}));
  EXPECT_TRUE(is_step(unit(kU), Op::kUnit, {kU.node}));
  EXPECT_TRUE(is_step(saturate(kU), Op::kSaturate, {kU.node}));
  EXPECT_TRUE(is_step(make_vec(kX, kY, kX), Op::kCombine, {kX.node, kY.node, kX.node}));
  EXPECT_TRUE(is_step(grey(kX), Op::kGrey, {kX.node}));
  EXPECT_TRUE(is_step(x_of(kU), Op::kX, {kU.node}));
  EXPECT_TRUE(is_step(y_of(kU), Op::kY, {kU.node}));
  EXPECT_TRUE(is_step(z_of(kU), Op::kZ, {kU.node}));
}

TEST(Expression, arithmetic_on_numbers_is_done_at_once) {
  const Scalar a(6), b(1.5);
  EXPECT_TRUE(is_number(a + b, 7.5));
  EXPECT_TRUE(is_number(a - b, 4.5));
  EXPECT_TRUE(is_number(a * b, 9));
  EXPECT_TRUE(is_number(a / b, 4));
  EXPECT_TRUE(is_number(max(a, b), 6));
  EXPECT_TRUE(is_number(min(a, b), 1.5));
  EXPECT_TRUE(is_number(abs(Scalar(-3)), 3));
  EXPECT_TRUE(is_number(saturate(a), 1));
  EXPECT_TRUE(is_number(saturate(Scalar(-3)), 0));
}

TEST(Expression, powers_roots_and_logarithms_of_numbers_are_left_to_the_language) {
  EXPECT_EQ(power(Scalar(2), Scalar(3)).node->op, Op::kPower);
  EXPECT_EQ(sqrt(Scalar(4)).node->op, Op::kSqrt);
  EXPECT_EQ(exp(Scalar(0)).node->op, Op::kExp);
  EXPECT_EQ(log(Scalar(1)).node->op, Op::kLog);
}

TEST(Expression, zero_and_one_leave_no_step) {
  EXPECT_TRUE(is(kX + 0, kX));
  EXPECT_TRUE(is(Scalar(0) + kX, kX));
  EXPECT_TRUE(is(kX - 0, kX));
  EXPECT_TRUE(is(kX * 1, kX));
  EXPECT_TRUE(is(Scalar(1) * kX, kX));
  EXPECT_TRUE(is_number(kX * 0, 0));
  EXPECT_TRUE(is_number(Scalar(0) * kX, 0));
  EXPECT_TRUE(is(kX / 1, kX));
  EXPECT_TRUE(is_number(Scalar(0) / kX, 0));
  const Scalar magnitude = abs(kX);
  EXPECT_TRUE(is(power(magnitude, 1), magnitude));
  EXPECT_TRUE(is_number(power(magnitude, 0), 1));
}

TEST(Expression, other_numbers_do) {
  EXPECT_EQ((Scalar(0) - kX).node->op, Op::kSubtract);
  EXPECT_EQ((Scalar(1) / kX).node->op, Op::kDivide);
  EXPECT_EQ((kX * -1).node->op, Op::kMultiply);
  EXPECT_EQ((kX + 1).node->op, Op::kAdd);
  EXPECT_EQ(power(abs(kX), 2).node->op, Op::kPower);
}

TEST(Expression, zero_and_one_leave_no_step_on_vectors) {
  const ScalarVec zero = grey(Scalar(0)), one = grey(Scalar(1));
  EXPECT_TRUE(is(kU + zero, kU));
  EXPECT_TRUE(is(zero + kU, kU));
  EXPECT_TRUE(is(kU - zero, kU));
  EXPECT_TRUE(is(kU * Scalar(1), kU));
  EXPECT_TRUE(is_vector_constant(kU * Scalar(0), {0, 0, 0}));
  EXPECT_TRUE(is(modulate(kU, one), kU));
  EXPECT_TRUE(is(modulate(one, kU), kU));
  EXPECT_TRUE(is_vector_constant(modulate(zero, kU), {0, 0, 0}));
  EXPECT_TRUE(is_number(dot(zero, kU), 0));
  EXPECT_TRUE(is_number(dot(kU, zero), 0));
}

TEST(Expression, grey_vectors_are_computed_as_one_number) {
  const ScalarVec a = grey(kX), b = grey(kY);
  EXPECT_EQ((a + b).node->op, Op::kGrey);
  EXPECT_EQ((a + b).node->arguments[0]->op, Op::kAdd);
  EXPECT_EQ((a - b).node->arguments[0]->op, Op::kSubtract);
  EXPECT_EQ(modulate(a, b).node->arguments[0]->op, Op::kMultiply);
  EXPECT_EQ((a * kY).node->arguments[0]->op, Op::kMultiply);
  EXPECT_EQ(saturate(a).node->arguments[0]->op, Op::kSaturate);
  EXPECT_EQ((a + grey(Scalar(2))).node->arguments[0]->op, Op::kAdd);
  EXPECT_TRUE(is_step(modulate(kU, a), Op::kScale, {kU.node, kX.node}));
  EXPECT_TRUE(is_step(modulate(a, kU), Op::kScale, {kU.node, kX.node}));
  EXPECT_EQ((a + kU).node->op, Op::kAdd);  // one of them is not
  EXPECT_TRUE((a + kU).node->is_vector);
}

TEST(Expression, vectors_of_numbers_are_one_constant) {
  EXPECT_TRUE(is_vector_constant(make_vec(Scalar(1), Scalar(2), Scalar(3)), {1, 2, 3}));
  EXPECT_TRUE(is_vector_constant(grey(Scalar(2)), {2, 2, 2}));
  EXPECT_TRUE(is_vector_constant(make_vec(Scalar(1), Scalar(2), Scalar(3) + Scalar(1)), {1, 2, 4}));
  EXPECT_EQ(make_vec(Scalar(1), Scalar(2), kX).node->op, Op::kCombine);
  const ScalarVec c = constant_vec<Scalar>({1, 2, 3});
  EXPECT_TRUE(is_number(dot(c, c), 14));
}

TEST(Expression, a_vector_of_one_scalar_thrice_is_grey) {
  EXPECT_TRUE(is_step(make_vec(kX, kX, kX), Op::kGrey, {kX.node}));
  EXPECT_EQ(make_vec(kX, kX, kY).node->op, Op::kCombine);
  EXPECT_EQ(make_vec(kY, kX, kX).node->op, Op::kCombine);
}

TEST(Expression, components_of_what_was_just_put_together_are_no_step) {
  const ScalarVec combined = make_vec(kX, kY, Scalar(4));
  EXPECT_TRUE(is(x_of(combined), kX));
  EXPECT_TRUE(is(y_of(combined), kY));
  EXPECT_TRUE(is_number(z_of(combined), 4));
  EXPECT_TRUE(is(z_of(grey(kX)), kX));
  const ScalarVec constant = constant_vec<Scalar>({1, 2, 3});
  EXPECT_TRUE(is_number(x_of(constant), 1));
  EXPECT_TRUE(is_number(y_of(constant), 2));
  EXPECT_TRUE(is_number(z_of(constant), 3));
}

TEST(Expression, a_choice_between_numbers_is_made_at_once) {
  EXPECT_TRUE(is(select_less(Scalar(1), Scalar(2), kX, kY), kX));
  EXPECT_TRUE(is(select_less(Scalar(2), Scalar(2), kX, kY), kY));
  EXPECT_TRUE(is_number(select_less(kX, kY, Scalar(5), Scalar(5)), 5));
  EXPECT_EQ(select_less(kX, kY, Scalar(5), Scalar(6)).node->op, Op::kSelectLess);
}

TEST(Expression, a_limit_that_a_number_keeps_anyway_is_no_step) {
  const Scalar square = kX * kX, size = dot(kU, kU), shifted = abs(kX) + 2;
  EXPECT_TRUE(is(max(square, 0), square));
  EXPECT_TRUE(is(max(size, -1), size));
  EXPECT_TRUE(is(max(shifted, 2), shifted));
  EXPECT_EQ(max(shifted, 3).node->op, Op::kMaximum);
  EXPECT_EQ(max(kX, 0).node->op, Op::kMaximum);
}

TEST(Expression, saturating_once_is_enough) {
  const Scalar saturated = saturate(kX);
  EXPECT_TRUE(is(saturate(saturated), saturated));
  EXPECT_TRUE(is_step(saturate(max(kX, 0)), Op::kSaturate, {kX.node}));
  EXPECT_TRUE(is_step(saturate(max(kX, -2)), Op::kSaturate, {kX.node}));
  EXPECT_EQ(saturate(max(kX, 0.5)).node->arguments[0]->op, Op::kMaximum);
}

TEST(Expression, a_name_once_given_stays) {
  const Scalar sum = named("first", kX + kY);
  EXPECT_EQ(sum.node->name, "first");
  EXPECT_EQ(named("second", sum).node->name, "first");
  EXPECT_EQ(named("mine", kX).node->name, "x");
}

TEST(Expression, numbers_have_no_name_and_grey_vectors_that_of_their_number) {
  EXPECT_EQ(named("two", Scalar(2)).node->name, "");
  EXPECT_EQ(named("white", grey(Scalar(1))).node->name, "");
  const ScalarVec light = named("light", grey(kX + kY));
  EXPECT_EQ(light.node->op, Op::kGrey);
  EXPECT_EQ(light.node->name, "");
  EXPECT_EQ(light.node->arguments[0]->name, "light");
  EXPECT_EQ(named("sum", kU + kV).node->name, "sum");
}

TEST(Expression, a_shared_argument_is_visited_once) {
  Scalar x = scalar_parameter("x", 2);
  // Without sharing the walk would take 2^60 steps.
  for (int i = 0; i < 60; ++i) x = x + x;
  EXPECT_EQ(in_order({x.node}).size(), 61u);
}

TEST(Expression, several_roots_share_their_steps) {
  const Scalar shared = kX * kY;
  const std::vector<NodePtr> roots{(shared + 1).node, (shared - 1).node, shared.node};
  const std::vector<const Node*> order = in_order(roots);
  EXPECT_EQ(order.size(), 7u);  // x, y, their product, 1, 1, sum, difference
  EXPECT_EQ(order[2], shared.node.get());
}

}  // namespace
}  // namespace lumaknot
