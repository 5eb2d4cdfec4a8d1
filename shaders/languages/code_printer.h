/// A recorded formula as statements of a language.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shaders/graph/expression.h"

namespace lumaknot {

/// A function that printed code may call, defined above it.
struct Helper {
  std::string_view name, text;
};

/// How a language spells what a formula does. Defaults are C's. Braces hold what fmt::format() puts
/// in: names, or places of arguments.
struct Dialect {
  std::string_view scalar_type, vector_type;  ///< of a local variable's declaration
  std::string_view uv_type = {};              ///< of texture coordinates
  std::string_view declaration = "{type} {name} = {value};";
  std::string_view input = "{type} {name}";  ///< a function's
  std::string_view function = "{type} {name}({inputs}) {{\n{body}}}\n";
  std::string_view select = "({0} < {1} ? {2} : {3})";
  std::string_view vector_of;                  ///< "vec3({0}, {1}, {2})"
  std::string_view grey_of;                    ///< "vec3({0})"
  std::string_view component[3];               ///< "{0}.x", ...
  std::string_view saturate, vector_saturate;  ///< "clamp({0}, 0.0, 1.0)"
  std::string_view logarithm = "log", absolute = "abs", dot = "dot", cross = "cross";
  std::string_view vector_max = "max", vector_min = "min";
  /// Helpers for what languages leave open: powers of zero, the unit vector of zero.
  std::string_view power = "safe_power", unit = "safe_normalize";
  std::span<const Helper> helpers;
  bool capitalised = false;  ///< Names_Like_This, where the language's own are in lower case
  std::span<const std::string_view> reserved;  ///< words that no name may be
  /// How parameters are called, when not by identifier_of().
  std::string (*parameter_name)(std::string_view) = nullptr;
};

/// Printed statements and the expressions that they lead to.
struct PrintedCode {
  std::string statements;            ///< one a line, each indented
  std::vector<std::string> results;  ///< expressions, one a root
};

/// `roots` in `dialect`: what the formula names and what is used more than once becomes a variable,
/// the rest is written where it is used. Inputs and parameters are read by identifier_of() their
/// names.
PrintedCode print_code(const std::vector<NodePtr>& roots, const Dialect& dialect,
                       std::string_view indent);

/// `name` as the dialect spells it, never one of its reserved words.
std::string identifier_of(std::string_view name, const Dialect& dialect);

/// The name of a parameter in printed code.
std::string parameter_identifier(std::string_view name, const Dialect& dialect);

/// `line` indented and broken at spaces where it is too long; what follows is indented by four
/// more.
std::string wrapped_line(const std::string& line, std::string_view indent);

/// A number that reads back as the same double, always with a point or an exponent.
std::string number_text(double value);

}  // namespace lumaknot
