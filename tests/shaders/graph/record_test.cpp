#include "shaders/graph/record.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/graph/evaluate.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// Colours of one surface from two sides, compared for every view and shot.
template <class F>
void for_each_view_and_shot(F check) {
  for (const NamedView& view : every_view()) {
    for (const Shot& shot : every_shot()) check(view.view, shot, view.name + ": " + shot.name);
  }
}

/// The largest difference between the components, of full scale or of the larger component.
double apart(const Vec3d& a, const Vec3d& b) {
  return largest_magnitude(a - b) / std::max({1.0, largest_magnitude(a), largest_magnitude(b)});
}

// The same operations in the same order; the C library's pow, log and exp may be other versions
// when the compiler computes them.
constexpr double kSameOperations = 1e-15;

TEST(Record, recorded_formulas_compute_what_the_double_instance_computes) {
  RandomSurface random;
  for_each_view_and_shot([&](const View& view, const Shot& shot, const std::string& name) {
    const Recorded recorded = record_shot(view, shot);
    const auto lighting = lighting_of<double>(view, shot.material);
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint<double> point = random.point();
      const Vec3d texture = random.texture();
      const Vec3d expected =
          stage_color(point, texture_value(texture, shot.material), lighting, shot);
      const Vec3d found = evaluate(recorded, surface_inputs(point, texture, shot.material));
      ASSERT_LT(apart(found, expected), kSameOperations) << name;
    }
  });
}

TEST(Record, what_is_left_out_changes_no_colour) {
  RandomSurface random;
  // Zeros and ones among the numbers: what Keep::kNeeded folds.
  Material plain;
  plain.specular = 0;
  plain.parameters["darkness"] = 1;
  Material ones;
  ones.parameters["shininess"] = 1;
  ones.diffuse_color = {0, 0, 0};
  ones.emissive = {1, 1, 1};
  for (const Material& base : {plain, ones, colored_material()}) {
    for (const Shot& shot : every_shot(base)) {
      for (const NamedView& view : every_view()) {
        const SurfacePoint<double> point = random.point();
        const Inputs inputs = surface_inputs(point, random.texture(), shot.material);
        const Vec3d needed = evaluate(record_shot(view.view, shot, Keep::kNeeded), inputs);
        const Vec3d all = evaluate(record_shot(view.view, shot, Keep::kAll), inputs);
        ASSERT_EQ(needed, all) << view.name << ": " << shot.name;  // x * 1, x + 0, x^1 are exact
      }
    }
  }
}

TEST(Record, a_colour_in_place_of_the_texture_gives_the_same) {
  RandomSurface random;
  const View view = every_view().back().view;
  for (const Shot& shot : every_shot()) {
    const SurfacePoint<double> point = random.point();
    const Vec3d color = random.texture();
    const Recorded textured = record_shot(view, shot);
    const Recorded plain = record_shot(view, shot, Keep::kNeeded, color);
    const Inputs inputs = surface_inputs(point, color, shot.material);
    const Inputs no_texture{{"position", point.position}, {"normal", point.normal}};
    ASSERT_EQ(evaluate(plain, no_texture), evaluate(textured, inputs)) << shot.name;
  }
}

TEST(Record, light_at_vertices_gives_the_same_where_nothing_is_interpolated) {
  RandomSurface random;
  for_each_view_and_shot([&](const View& view, Shot shot, const std::string& name) {
    const Recorded a_pixel = record_shot(view, shot);
    shot.material.rate = ShadingFrequency::kVertex;
    const Recorded a_vertex = record_shot(view, shot);
    const Inputs inputs = surface_inputs(random.point(), random.texture(), shot.material);
    ASSERT_EQ(evaluate(a_vertex, inputs), evaluate(a_pixel, inputs)) << name;
  });
}

/// Every graph of a recorded shot.
std::vector<NodePtr> roots_of(const Recorded& recorded) {
  std::vector<NodePtr> roots{recorded.color};
  for (const Varying& varying : recorded.varyings) roots.push_back(varying.value);
  return roots;
}

TEST(Record, arguments_come_before_their_users_and_each_node_once) {
  for_each_view_and_shot([](const View& view, const Shot& shot, const std::string& name) {
    std::set<const Node*> seen;
    const Recorded recorded = record_shot(view, shot);
    for (const Node* node : in_order({recorded.color})) {
      for (const NodePtr& argument : node->arguments) ASSERT_TRUE(seen.contains(argument.get()));
      ASSERT_TRUE(seen.insert(node).second) << name;
    }
  });
}

/// The kinds of an operation's arguments, 's' or 'v', as a string; "" for any two of a kind.
std::string kinds_for(const Node& node) {
  switch (node.op) {
    case Op::kScale:
      return "vs";
    case Op::kDot:
    case Op::kCross:
      return "vv";
    case Op::kUnit:
    case Op::kX:
    case Op::kY:
    case Op::kZ:
      return "v";
    case Op::kCombine:
      return "sss";
    case Op::kGrey:
    case Op::kExp:
    case Op::kLog:
    case Op::kSqrt:
    case Op::kAbs:
      return "s";
    case Op::kDivide:
    case Op::kPower:
      return "ss";
    case Op::kSelectLess:
      return "ssss";
    case Op::kSaturate:
      return node.is_vector ? "v" : "s";
    case Op::kInput:
    case Op::kParameter:
    case Op::kConstant:
      return "";
    default:
      return node.is_vector ? "vv" : "ss";
  }
}

bool makes_a_vector(const Node& node) {
  switch (node.op) {
    case Op::kScale:
    case Op::kCross:
    case Op::kUnit:
    case Op::kCombine:
    case Op::kGrey:
      return true;
    case Op::kInput:
    case Op::kParameter:
    case Op::kConstant:
    case Op::kAdd:
    case Op::kSubtract:
    case Op::kMultiply:
    case Op::kMaximum:
    case Op::kMinimum:
    case Op::kSaturate:
      return node.is_vector;  // either
    default:
      return false;
  }
}

TEST(Record, kinds_of_arguments_fit_their_operations) {
  for_each_view_and_shot([](const View& view, const Shot& shot, const std::string& name) {
    const std::vector<NodePtr> roots = roots_of(record_shot(view, shot));
    for (const Node* node : in_order(roots)) {
      std::string kinds;
      for (const NodePtr& argument : node->arguments) kinds += argument->is_vector ? 'v' : 's';
      ASSERT_EQ(kinds, kinds_for(*node)) << name << " " << int(node->op);
      ASSERT_EQ(node->is_vector, makes_a_vector(*node)) << name << " " << int(node->op);
    }
  });
}

TEST(Record, the_picture_is_a_vector) {
  for_each_view_and_shot([](const View& view, const Shot& shot, const std::string& name) {
    EXPECT_TRUE(record_shot(view, shot).color->is_vector) << name;
  });
}

TEST(Record, inputs_and_parameters_of_one_name_are_one_kind_and_value) {
  for_each_view_and_shot([](const View& view, const Shot& shot, const std::string& name) {
    std::map<std::string, std::pair<bool, Vec3d>> known;
    const std::vector<NodePtr> roots = roots_of(record_shot(view, shot));
    for (const Node* node : in_order(roots)) {
      if (node->op != Op::kInput && node->op != Op::kParameter) continue;
      const std::pair<bool, Vec3d> found{node->is_vector, node->value};
      ASSERT_EQ(known.emplace(node->name, found).first->second, found) << name << node->name;
    }
  });
}

/// How many steps of a graph have the same operation on the same arguments as another.
int repeated_steps(const NodePtr& root) {
  std::map<const Node*, std::size_t> number;  // the same for equal steps
  std::map<std::string, std::size_t> known;
  int repeated = 0;
  for (const Node* node : in_order({root})) {
    std::string text = std::to_string(int(node->op)) + (node->is_vector ? "v" : "s");
    if (node->arguments.empty()) {
      for (const double c : components(node->value)) text += std::to_string(c) + node->name;
    }
    for (const NodePtr& argument : node->arguments) {
      text += "," + std::to_string(number.at(argument.get()));
    }
    const auto [found, is_new] = known.emplace(text, known.size());
    number[node] = found->second;
    // A constant is not a step: it is written where it is read.
    if (node->op != Op::kConstant) repeated += !is_new;
  }
  return repeated;
}

TEST(Record, no_step_of_one_light_is_recorded_twice) {
  const View view = every_view()[1].view;  // a plain point light
  for (const Shot& shot : every_shot()) {
    // Reducing chroma computes the grey of the lit brightness beside the colour itself.
    if (shot.material.gamut == Gamut::kChroma) continue;
    // Cook and Torrance's formula has max(n.l, 0) and 1 - alpha^2 twice; a compiler shares them.
    const int written_twice = shot.material.model == Model::kCookTorrance ? 2 : 0;
    EXPECT_LE(repeated_steps(record_shot(view, shot).color), written_twice) << shot.name;
  }
}

}  // namespace
}  // namespace lumaknot
