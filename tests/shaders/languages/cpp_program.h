/// Formulas printed as C++, compiled by the compiler of the build, and run.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "shaders/languages/code_printer.h"
#include "tests/shaders/graph/evaluate.h"

namespace lumaknot {

inline constexpr Dialect kCppDialect{.scalar_type = "const double",
                                     .vector_type = "const vec3",
                                     .declaration = "{type} {name} = {value};",
                                     .vector_of = "vec3({0}, {1}, {2})",
                                     .grey_of = "vec3({0})",
                                     .component = {"{0}.x", "{0}.y", "{0}.z"},
                                     .saturate = "clamp({0}, 0.0, 1.0)",
                                     .vector_saturate = "clamp({0}, 0.0, 1.0)",
                                     .helpers = {},
                                     .reserved = {}};

/// GLSL features that C++ lacks.
inline constexpr const char* kCppPrelude = R"(#include <cmath>
#include <cstdio>
namespace {
struct vec3 {
  double x, y, z;
  vec3(double a, double b, double c) : x(a), y(b), z(c) {}
  explicit vec3(double a) : x(a), y(a), z(a) {}
};
[[maybe_unused]] vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[maybe_unused]] vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[maybe_unused]] vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
[[maybe_unused]] vec3 operator*(vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double max(double a, double b) { return a < b ? b : a; }
double min(double a, double b) { return b < a ? b : a; }
double clamp(double a, double low, double high) { return a < low ? low : a > high ? high : a; }
vec3 clamp(vec3 a, double low, double high) {
  return {clamp(a.x, low, high), clamp(a.y, low, high), clamp(a.z, low, high)};
}
double abs(double a) { return std::fabs(a); }
double safe_power(double a, double b) { return std::pow(a, b); }
double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec3 cross(vec3 a, vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
vec3 safe_normalize(vec3 a) {
  const double size = std::sqrt(dot(a, a));
  return size > 0 ? vec3(a.x / size, a.y / size, a.z / size) : a;
}
std::FILE* output;
void write(vec3 a) { std::fprintf(output, "%a %a %a\n", a.x, a.y, a.z); }
void write(double a) { write(vec3(a, 0, 0)); }
)";

/// The inputs and parameters of a graph as C++ declares them, each with a value.
inline std::string cpp_values(const NodePtr& root, const Inputs& inputs) {
  std::map<std::string, std::string> lines;  // each name once
  for (const Node* node : in_order({root})) {
    if (node->op != Op::kInput && node->op != Op::kParameter) continue;
    const Vec3d v = node->op == Op::kInput ? inputs.at(node->name) : node->value;
    const std::string name = identifier_of(node->name, kCppDialect);
    lines[name] = node->is_vector
                      ? fmt::format("  const vec3 {}({:a}, {:a}, {:a});\n", name, v.x, v.y, v.z)
                      : fmt::format("  const double {} = {:a};\n", name, v.x);
  }
  std::string text;
  for (const auto& [name, line] : lines) text += line;
  return text;
}

/// Functions of a C++ program, each of which writes one value.
class CppProgram {
 public:
  CppProgram() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "lumaknot-formulas-XXXXXX").string();
    if (::mkdtemp(pattern.data())) folder_ = pattern;
  }
  ~CppProgram() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  CppProgram(const CppProgram&) = delete;
  CppProgram& operator=(const CppProgram&) = delete;

  void add(const NodePtr& root, const Inputs& inputs) {
    const PrintedCode code = print_code({root}, kCppDialect, "  ");
    functions_ += fmt::format("void f{}() {{\n{}{}  write({});\n}}\n", count_,
                              cpp_values(root, inputs), code.statements, code.results.at(0));
    calls_ += fmt::format("  f{}();\n", count_++);
  }

  /// What the functions write, in the order they were added; empty after a failure, which is
  /// reported.
  std::vector<Vec3d> run() const {
    const std::string source = folder_ / "formulas.cpp", program = folder_ / "formulas",
                      output = folder_ / "values";
    std::ofstream(source) << kCppPrelude << functions_ << "}\nint main(int, char** argv) {\n"
                          << "  output = std::fopen(argv[1], \"w\");\n"
                          << calls_ << "  return std::fclose(output);\n}\n";
    // One rounding per written operation, none computed by the compiler's own library.
    const bool built = succeeds({LUMAKNOT_COMPILER, "-std=c++20", "-ffp-contract=off",
                                 "-fno-builtin", "-w", source, "-o", program});
    EXPECT_TRUE(built) << LUMAKNOT_COMPILER;
    if (!built || !succeeds({program, output})) return {};
    return values(output);
  }

 private:
  static bool succeeds(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) {
      return false;
    }
    int status = 1;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  static std::vector<Vec3d> values(const std::string& path) {
    std::ifstream file(path);
    std::vector<Vec3d> result;
    for (std::string x, y, z; file >> x >> y >> z;) {
      const auto number = [](const std::string& text) {
        return std::strtod(text.c_str(), nullptr);
      };
      result.push_back({number(x), number(y), number(z)});
    }
    return result;
  }

  std::filesystem::path folder_;
  std::string functions_, calls_;
  int count_ = 0;
};

}  // namespace lumaknot
