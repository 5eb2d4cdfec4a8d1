// How formulas are spelled: names, numbers, brackets, lines. That they mean the same:
// printed_code_test.cpp.
#include "shaders/languages/code_printer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "shaders/languages/backend.h"
#include "shaders/languages/functions.h"
#include "tests/shaders/graph/random_expression.h"
#include "tests/shaders/languages/every_shot.h"

namespace lumaknot {
namespace {

using testing::HasSubstr;
using testing::Not;

const Scalar kX = scalar_input("x"), kY = scalar_input("y"), kZ = scalar_input("z");
const ScalarVec kU = vector_input("u"), kV = vector_input("v");

const std::map<std::string, const Dialect*> kDialects{{"GLSL", &dialect_of(Language::kGlsl330)},
                                                      {"HLSL", &dialect_of(Language::kHlsl)},
                                                      {"fx", &dialect_of(Language::kFx)},
                                                      {"OSL", &dialect_of(Language::kOsl)}};

/// `root` as one GLSL expression, which needs no statement.
std::string glsl(const NodePtr& root) {
  const PrintedCode code = print_code({root}, dialect_of(Language::kGlsl330), "");
  EXPECT_EQ(code.statements, "");
  return code.results.at(0);
}
std::string glsl(const Scalar& s) { return glsl(s.node); }
std::string glsl(const ScalarVec& v) { return glsl(v.node); }

TEST(CodePrinter, brackets_stand_where_the_order_of_steps_needs_them) {
  EXPECT_EQ(glsl(kX + kY + kZ), "x + y + z");
  EXPECT_EQ(glsl(kX + (kY + kZ)), "x + (y + z)");
  EXPECT_EQ(glsl(kX - (kY - kZ)), "x - (y - z)");
  EXPECT_EQ(glsl((kX - kY) - kZ), "x - y - z");
  EXPECT_EQ(glsl(kX * kY + kZ), "x * y + z");
  EXPECT_EQ(glsl(kX * (kY + kZ)), "x * (y + z)");
  EXPECT_EQ(glsl((kX - kY) / kZ), "(x - y) / z");
  EXPECT_EQ(glsl(kX / (kY * kZ)), "x / (y * z)");
  EXPECT_EQ(glsl(kX / kY * kZ), "x / y * z");
  EXPECT_EQ(glsl((kU + kV) * (kX + kY)), "(u + v) * (x + y)");
}

TEST(CodePrinter, negative_numbers_keep_their_sign_apart) {
  EXPECT_EQ(glsl(kX - Scalar(-2)), "x - -2.0");
  EXPECT_EQ(glsl(Scalar(-2) * kX), "-2.0 * x");
  EXPECT_EQ(glsl(kX / Scalar(-0.5)), "x / -0.5");
}

TEST(CodePrinter, a_choice_is_bracketed_as_a_whole) {
  EXPECT_EQ(glsl(select_less(kX, kY + kZ, kX, kY) * kZ), "(x < y + z ? x : y) * z");
  EXPECT_EQ(glsl(select_less(select_less(kX, kY, kX, kY), kZ, kX, kY)),
            "((x < y ? x : y) < z ? x : y)");
}

TEST(CodePrinter, functions_are_the_dialect_s) {
  EXPECT_EQ(glsl(saturate(kX)), "clamp(x, 0.0, 1.0)");
  EXPECT_EQ(glsl(unit(cross(kU, kV))), "safe_normalize(cross(u, v))");
  EXPECT_EQ(glsl(grey(kX)), "vec3(x)");
  EXPECT_EQ(glsl(make_vec(kX, kY, Scalar(1))), "vec3(x, y, 1.0)");
  EXPECT_EQ(glsl(y_of(kU)), "u.y");
  const PrintedCode hlsl = print_code({saturate(kU).node}, dialect_of(Language::kHlsl), "");
  EXPECT_EQ(hlsl.results[0], "saturate(u)");
  const PrintedCode osl =
      print_code({z_of(vector_input("normal_map")).node}, dialect_of(Language::kOsl), "");
  EXPECT_EQ(osl.results[0], "normal_map[2]");
}

TEST(CodePrinter, the_language_s_own_power_takes_no_zero) {
  EXPECT_EQ(glsl(power(abs(kX) + 1, kY)), "pow(abs(x) + 1.0, y)");
  EXPECT_EQ(glsl(power(max(kX, 0), kY)), "safe_power(max(x, 0.0), y)");
}

TEST(CodePrinter, what_is_used_twice_or_named_is_a_variable) {
  const Scalar product = kX * kY;
  const PrintedCode code =
      print_code({(product + product).node}, dialect_of(Language::kGlsl330), "  ");
  EXPECT_EQ(code.statements, "  float value = x * y;\n");
  EXPECT_EQ(code.results[0], "value + value");
  const PrintedCode with_name =
      print_code({(named("n_dot_l", dot(kU, kV)) + 1).node}, dialect_of(Language::kGlsl330), "  ");
  EXPECT_EQ(with_name.statements, "  float n_dot_l = dot(u, v);\n");
  EXPECT_EQ(with_name.results[0], "n_dot_l + 1.0");
}

TEST(CodePrinter, components_are_taken_of_variables_alone) {
  const PrintedCode code = print_code({x_of(kU + kV).node}, dialect_of(Language::kGlsl330), "");
  EXPECT_EQ(code.statements, "vec3 value = u + v;\n");
  EXPECT_EQ(code.results[0], "value.x");
}

TEST(CodePrinter, several_roots_share_their_variables) {
  const Scalar product = kX * kY;
  const PrintedCode code =
      print_code({(product + 1).node, (product - 1).node}, dialect_of(Language::kGlsl330), "");
  EXPECT_EQ(code.statements, "float value = x * y;\n");
  EXPECT_EQ(code.results, (std::vector<std::string>{"value + 1.0", "value - 1.0"}));
}

TEST(CodePrinter, numbers_always_have_a_point_or_an_exponent_and_read_back) {
  for (const double value : {0.0, -0.0, 1.0, -3.0, 0.1, 1e-5, 1e21, 1e300, 5e-324, 1.0 / 3.0,
                             123456789.0, 1e16, -1e15, 0.30000000000000004}) {
    const std::string text = number_text(value);
    EXPECT_NE(text.find_first_of(".e"), text.npos) << text;
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_EQ(text.find(','), text.npos) << text;
  }
}

/// The names that `code` declares, in its order.
std::vector<std::string> declared(const std::string& code, const Dialect& dialect) {
  const std::regex declaration("(?:^|\n) *(?:" + std::string(dialect.scalar_type) + "|" +
                               std::string(dialect.vector_type) + ")\\s+(\\w+) =");
  std::vector<std::string> names;
  for (std::sregex_iterator i(code.begin(), code.end(), declaration), end; i != end; ++i) {
    names.push_back((*i)[1]);
  }
  return names;
}

/// Every name that `recorded` reads, as the dialect spells it.
std::set<std::string> read_names(const NodePtr& root, const Dialect& dialect) {
  std::set<std::string> names;
  for (const Node* node : in_order({root})) {
    if (node->op == Op::kInput) names.insert(identifier_of(node->name, dialect));
    if (node->op == Op::kParameter) names.insert(parameter_identifier(node->name, dialect));
  }
  return names;
}

TEST(CodePrinter, no_two_variables_of_any_formula_collide) {
  for (const NamedView& view : every_view()) {
    for (const Shot& shot : every_shot()) {
      const NodePtr root = record_shot(view.view, shot).color;
      for (const auto& [language, dialect] : kDialects) {
        std::set<std::string> taken = read_names(root, *dialect);
        for (const std::string& name :
             declared(print_code({root}, *dialect, "  ").statements, *dialect)) {
          ASSERT_TRUE(taken.insert(name).second) << language << " " << name << " " << shot.name;
          ASSERT_EQ(std::ranges::count(dialect->reserved, name), 0) << language << " " << name;
        }
      }
    }
  }
}

TEST(CodePrinter, equal_names_are_numbered) {
  const Scalar a = named("term", kX * kY), b = named("term", kX + kY);
  const Scalar c = named("term2", kX - kY), d = named("x", kX / kY);
  const PrintedCode code = print_code({(a + b + c + d).node}, dialect_of(Language::kGlsl330), "");
  EXPECT_EQ(declared(code.statements, dialect_of(Language::kGlsl330)),
            (std::vector<std::string>{"term", "term2", "term22", "x2"}));
}

TEST(CodePrinter, reserved_words_get_changed) {
  for (const auto& [language, dialect] : kDialects) {
    ASSERT_FALSE(dialect->reserved.empty()) << language;
    for (const std::string_view word : dialect->reserved) {
      const std::string name = identifier_of(word, *dialect);
      EXPECT_EQ(std::ranges::count(dialect->reserved, name), 0) << language << " " << word;
    }
  }
  EXPECT_EQ(identifier_of("float", dialect_of(Language::kGlsl330)), "float_value");
  EXPECT_EQ(identifier_of("n_dot_l", dialect_of(Language::kGlsl330)), "n_dot_l");
}

TEST(CodePrinter, a_variable_whose_changed_name_is_taken_is_numbered) {
  const Scalar a = named("float", kX * kY), b = named("float_value", kX + kY);
  const PrintedCode code = print_code({(a + b).node}, dialect_of(Language::kGlsl330), "");
  const std::vector<std::string> names = declared(code.statements, dialect_of(Language::kGlsl330));
  ASSERT_EQ(names.size(), 2u);
  EXPECT_NE(names[0], names[1]);
}

TEST(CodePrinter, capitalised_names_are_so_at_each_word) {
  Dialect dialect = dialect_of(Language::kGlsl330);
  dialect.capitalised = true;
  EXPECT_EQ(identifier_of("n_dot_l", dialect), "N_Dot_L");
  EXPECT_EQ(identifier_of("light2_position", dialect), "Light2_Position");
}

TEST(CodePrinter, the_formula_s_names_appear_in_every_language) {
  Shot shot{"s", Stage::kFinal, *with_formula(Material{}, "yiq-eq6")};
  const NodePtr root = record_shot(View{}, shot).color;
  for (const auto& [language, dialect] : kDialects) {
    const PrintedCode code = print_code({root}, *dialect, "  ");
    for (const char* name : {"n_dot_l", "to_light", "r_dot_v", "highlight", "lit_brightness"}) {
      EXPECT_THAT(code.statements, HasSubstr(std::string(" ") + name + " =")) << language;
    }
  }
}

TEST(CodePrinter, lines_are_no_longer_than_100_columns) {
  RandomGraph random(11);
  int wrapped = 0;
  const auto check = [&](const NodePtr& root, const Dialect& dialect) {
    std::istringstream lines(print_code({root}, dialect, "    ").statements);
    for (std::string line; std::getline(lines, line);) {
      ASSERT_LE(line.size(), 100u) << line;
      ASSERT_FALSE(line.ends_with(' ')) << line;
      ASSERT_TRUE(line.starts_with("    ")) << line;
      wrapped += line.starts_with("        ");
    }
  };
  for (int i = 0; i < 200; ++i)
    check(named("all", random.vector(6)).node, dialect_of(Language::kGlsl330));
  for (const auto& [language, dialect] : kDialects) {
    for (const Shot& shot : every_shot()) {
      check(record_shot(every_view().back().view, shot).color, *dialect);
    }
  }
  EXPECT_GT(wrapped, 100);
}

TEST(CodePrinter, a_token_that_fits_no_line_stays_whole) {
  const std::string token(120, 'a');
  EXPECT_EQ(wrapped_line(token + ";", "    "), "    " + token + ";\n");
  EXPECT_THAT(wrapped_line("float x = " + token + " + 1.0;", "  "), HasSubstr(token));
}

TEST(CodePrinter, the_same_formula_gives_the_same_text) {
  for (const Shot& shot : final_shots()) {
    const View view = every_view().back().view;
    const PrintedCode once =
        print_code({record_shot(view, shot).color}, dialect_of(Language::kGlsl330), "  ");
    const PrintedCode again =
        print_code({record_shot(view, shot).color}, dialect_of(Language::kGlsl330), "  ");
    EXPECT_EQ(once.statements, again.statements) << shot.name;
    EXPECT_EQ(once.results, again.results) << shot.name;
  }
}

}  // namespace
}  // namespace lumaknot
