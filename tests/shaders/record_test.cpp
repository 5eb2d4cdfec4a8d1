#include "shaders/record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "shaders/lighting.h"
#include "tests/shaders/every_shot.h"
#include "tests/shaders/random_surface.h"

namespace lumaknot {
namespace {

template <class F>
Vec3d by_component(const Vec3d& a, const Vec3d& b, F f) {
  return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}

Vec3d unit_or_zero(const Vec3d& v) {
  const double size = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return size > 0 ? Vec3d{v.x / size, v.y / size, v.z / size} : v;
}

/// Runs one node on its arguments' values; a scalar is kept in x.
Vec3d run(const Node& node, const std::vector<Vec3d>& a, const SurfacePoint<double>& point) {
  switch (node.op) {
    case Op::kInput:
      return node.name == "position" ? point.position
             : node.name == "normal" ? point.normal
                                     : point.texture;
    case Op::kParameter:
    case Op::kConstant:
      return node.value;
    case Op::kAdd:
      return by_component(a[0], a[1], [](double x, double y) { return x + y; });
    case Op::kSubtract:
      return by_component(a[0], a[1], [](double x, double y) { return x - y; });
    case Op::kMultiply:
      return by_component(a[0], a[1], [](double x, double y) { return x * y; });
    case Op::kMaximum:
      return by_component(a[0], a[1], [](double x, double y) { return x > y ? x : y; });
    case Op::kMinimum:
      return by_component(a[0], a[1], [](double x, double y) { return x < y ? x : y; });
    case Op::kPower:
      return {std::pow(a[0].x, a[1].x), 0, 0};
    case Op::kScale:
      return {a[0].x * a[1].x, a[0].y * a[1].x, a[0].z * a[1].x};
    case Op::kDot:
      return {a[0].x * a[1].x + a[0].y * a[1].y + a[0].z * a[1].z, 0, 0};
    case Op::kUnit:
      return unit_or_zero(a[0]);
    case Op::kCombine:
      return {a[0].x, a[1].x, a[2].x};
  }
  ADD_FAILURE() << "an operation without a meaning";
  return {};
}

Vec3d evaluate(const NodePtr& root, const SurfacePoint<double>& point) {
  std::unordered_map<const Node*, Vec3d> values;
  for (const Node* node : in_order(root)) {
    std::vector<Vec3d> arguments;
    for (const NodePtr& argument : node->arguments) {
      arguments.push_back(values.at(argument.get()));  // throws unless it came before
    }
    values[node] = run(*node, arguments, point);
  }
  return values.at(root.get());
}

View some_view() {
  View view;
  view.camera.position = {3, -2, 4};
  view.light.position = {-2, -3, 3.5};
  view.ambient = 0.3;
  return view;
}

std::multiset<std::string> names(const NodePtr& root) {
  std::multiset<std::string> result;
  for (const Node* node : in_order(root)) {
    if (!node->name.empty()) result.insert(node->name);
  }
  return result;
}

Shot final_shot(Space space) {
  Shot shot;
  shot.material.space = space;
  return shot;
}

TEST(Record, recorded_formulas_compute_what_the_double_instance_computes) {
  const View view = some_view();
  for (const Shot& shot : every_shot()) {
    const NodePtr root = record_shot(view, shot);
    const auto lighting = lighting_of<double>(view, shot.material);
    RandomSurface random;
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint<double> point = random.point();
      const Vec3d apart = evaluate(root, point) - stage_color(point, lighting, shot);
      // The same operations; a vector divided by its length may round once more, times 20.
      ASSERT_LT(length(apart), 1e-14) << shot.name;
    }
  }
}

TEST(Record, arguments_come_before_their_users_and_each_node_once) {
  for (const Shot& shot : every_shot()) {
    std::set<const Node*> seen;
    const NodePtr root = record_shot(some_view(), shot);
    for (const Node* node : in_order(root)) {
      for (const NodePtr& argument : node->arguments) EXPECT_TRUE(seen.contains(argument.get()));
      EXPECT_TRUE(seen.insert(node).second) << shot.name;
    }
  }
}

TEST(Record, no_step_is_recorded_twice) {
  for (const Shot& shot : every_shot()) {
    std::map<const Node*, std::string> signature;
    std::set<std::string> steps;
    const NodePtr root = record_shot(some_view(), shot);
    for (const Node* node : in_order(root)) {
      std::string text = std::to_string(int(node->op)) + (node->is_vector ? "v" : "s");
      const bool leaf = node->arguments.empty();
      if (leaf)
        text += node->name + std::to_string(node->value.x) + "," + std::to_string(node->value.y) +
                "," + std::to_string(node->value.z);
      for (const NodePtr& argument : node->arguments) text += "(" + signature[argument.get()] + ")";
      signature[node] = text;
      if (node->op == Op::kConstant) continue;  // no step, and written where it is read
      EXPECT_TRUE(steps.insert(text).second) << shot.name << ": " << node->name;
    }
  }
}

TEST(Record, kinds_of_arguments_fit_their_operations) {
  for (const Shot& shot : every_shot()) {
    const NodePtr root = record_shot(some_view(), shot);
    for (const Node* node : in_order(root)) {
      const auto& a = node->arguments;
      switch (node->op) {
        case Op::kInput:
        case Op::kParameter:
        case Op::kConstant:
          EXPECT_TRUE(a.empty());
          break;
        case Op::kScale:
          ASSERT_EQ(a.size(), 2u);
          EXPECT_TRUE(node->is_vector && a[0]->is_vector && !a[1]->is_vector);
          break;
        case Op::kDot:
          ASSERT_EQ(a.size(), 2u);
          EXPECT_TRUE(!node->is_vector && a[0]->is_vector && a[1]->is_vector);
          break;
        case Op::kUnit:
          ASSERT_EQ(a.size(), 1u);
          EXPECT_TRUE(node->is_vector && a[0]->is_vector);
          break;
        case Op::kCombine:
          ASSERT_EQ(a.size(), 3u);
          EXPECT_TRUE(node->is_vector);
          for (const NodePtr& argument : a) EXPECT_FALSE(argument->is_vector);
          break;
        default:
          ASSERT_EQ(a.size(), 2u);
          EXPECT_EQ(a[0]->is_vector, node->is_vector);
          EXPECT_EQ(a[1]->is_vector, node->is_vector);
      }
    }
  }
}

TEST(Record, the_picture_is_a_vector) {
  for (const Shot& shot : every_shot()) {
    EXPECT_TRUE(record_shot(some_view(), shot)->is_vector) << shot.name;
  }
}

TEST(Record, names_of_the_formula_appear_once_each) {
  EXPECT_EQ(names(record_shot(some_view(), final_shot(Space::kYiq))),
            (std::multiset<std::string>{
                "position",     "normal",         "texture",                         // inputs
                "eye_position", "light_position", "ambient", "diffuse", "specular",  // parameters
                "shininess",    "luma_offset",                                       //
                "to_eye",       "to_light",       "n",       "n_dot_l", "reflection",
                "r_dot_v",  // eq. 1, 2
                "light",        "highlight",      "y",       "i",       "q",
                "lit_luma"}));  // eq. 4, 6
}

TEST(Record, parameters_hold_the_scene_s_numbers) {
  Shot shot = final_shot(Space::kYiq);
  shot.material.shininess = 17;
  shot.material.luma_offset = -0.25;
  std::map<std::string, Vec3d> values;
  const NodePtr root = record_shot(some_view(), shot);
  for (const Node* node : in_order(root)) {
    if (node->op == Op::kParameter) values[node->name] = node->value;
  }
  EXPECT_EQ(values["eye_position"], (Vec3d{3, -2, 4}));
  EXPECT_EQ(values["light_position"], (Vec3d{-2, -3, 3.5}));
  EXPECT_EQ(values["ambient"].x, 0.3);
  EXPECT_EQ(values["shininess"].x, 17);
  EXPECT_EQ(values["luma_offset"].x, -0.25);
}

TEST(Record, the_texture_stage_is_one_node) {
  Shot shot;
  shot.stage = Stage::kTexture;
  const NodePtr root = record_shot(some_view(), shot);
  EXPECT_EQ(in_order(root).size(), 1u);
  EXPECT_EQ(root->op, Op::kInput);
  EXPECT_EQ(root->name, "texture");
}

TEST(Record, the_diffuse_stage_needs_light_position_and_normal_alone) {
  Shot shot;
  shot.stage = Stage::kDiffuse;
  EXPECT_EQ(names(record_shot(some_view(), shot)),
            (std::multiset<std::string>{"position", "normal", "light_position", "to_light", "n",
                                        "n_dot_l"}));
}

TEST(Record, the_specular_stage_needs_neither_texture_nor_weights) {
  Shot shot;
  shot.stage = Stage::kSpecular;
  const auto found = names(record_shot(some_view(), shot));
  for (const char* name : {"texture", "ambient", "diffuse", "specular", "luma_offset"}) {
    EXPECT_FALSE(found.contains(name)) << name;
  }
  EXPECT_TRUE(found.contains("shininess"));
}

TEST(Record, phong_needs_no_luma) {
  const auto found = names(record_shot(some_view(), final_shot(Space::kRgb)));
  for (const char* name : {"y", "i", "q", "lit_luma", "luma_offset"}) {
    EXPECT_FALSE(found.contains(name)) << name;
  }
}

TEST(Record, an_interpolated_normal_is_not_made_unit) {
  Shot shot = final_shot(Space::kRgb);
  shot.material.normal = NormalUse::kInterpolated;
  const NodePtr root = record_shot(some_view(), shot);
  for (const Node* node : in_order(root)) {
    if (node->op != Op::kUnit) continue;
    EXPECT_NE(node->arguments[0]->name, "normal");
  }
  EXPECT_FALSE(names(record_shot(some_view(), shot)).contains("n"));
}

TEST(Expression, a_name_once_given_stays) {
  const Scalar sum = named("first", Scalar(1) + Scalar(2));
  EXPECT_EQ(named("second", sum).node->name, "first");
}

TEST(Expression, a_vector_of_constants_is_one_constant) {
  const ScalarVec v = make_vec(Scalar(1), Scalar(2), Scalar(3));
  EXPECT_EQ(v.node->op, Op::kConstant);
  EXPECT_TRUE(v.node->is_vector);
  EXPECT_EQ(v.node->value, (Vec3d{1, 2, 3}));
  EXPECT_EQ(make_vec(Scalar(1), Scalar(2), Scalar(3) + Scalar(1)).node->op, Op::kCombine);
}

TEST(Expression, a_shared_argument_is_visited_once) {
  Scalar x = scalar_parameter("x", 2);
  // Without sharing the walk would take 2^60 steps.
  for (int i = 0; i < 60; ++i) x = x + x;
  EXPECT_EQ(in_order(x.node).size(), 61u);
}

}  // namespace
}  // namespace lumaknot
