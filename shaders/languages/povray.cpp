#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>
#include <vector>

#include "shaders/languages/common.h"

namespace lumaknot::pov {
namespace {

/// A conditional computes both of its values, so neither may fail.
constexpr Helper kHelpers[] = {
    {"Lumaknot_Power",
     "// Base >= 0; 0 to the power 0 is 1.\n"
     "#macro Lumaknot_Power(Base, Exponent)\n"
     "  (Base > 0 ? pow(max(Base, 1e-300), Exponent) : (Exponent > 0 ? 0 : 1))\n"
     "#end\n\n"},
    {"Lumaknot_Normalize",
     "// Zero stays zero.\n"
     "#macro Lumaknot_Normalize(Vector)\n"
     "  (Vector / max(vlength(Vector), 1e-150))\n"
     "#end\n\n"},
    {"Lumaknot_Max",
     "#macro Lumaknot_Max(A, B)\n"
     "  <max(A.x, B.x), max(A.y, B.y), max(A.z, B.z)>\n"
     "#end\n\n"},
    {"Lumaknot_Min",
     "#macro Lumaknot_Min(A, B)\n"
     "  <min(A.x, B.x), min(A.y, B.y), min(A.z, B.z)>\n"
     "#end\n\n"},
    {"Lumaknot_Saturate",
     "// Each component limited to [0, 1].\n"
     "#macro Lumaknot_Saturate(Vector)\n"
     "  <min(max(Vector.x, 0), 1), min(max(Vector.y, 0), 1), min(max(Vector.z, 0), 1)>\n"
     "#end\n\n"},
};

/// The language's own words are in lower case, so capitalised names never clash. It has no types.
constexpr Dialect kDialect{.scalar_type = {},
                           .vector_type = {},
                           .declaration = "#local {name} = {value};",
                           .vector_of = "<{0}, {1}, {2}>",
                           .grey_of = "<{0}, {0}, {0}>",
                           .component = {"{0}.x", "{0}.y", "{0}.z"},
                           .saturate = "min(max({0}, 0.0), 1.0)",
                           .vector_saturate = "Lumaknot_Saturate({0})",
                           .logarithm = "ln",
                           .dot = "vdot",
                           .cross = "vcross",
                           .vector_max = "Lumaknot_Max",
                           .vector_min = "Lumaknot_Min",
                           .power = "Lumaknot_Power",
                           .unit = "Lumaknot_Normalize",
                           .helpers = kHelpers,
                           .capitalised = true,
                           .reserved = {}};

/// A parameter of the macro: its name, what it means, and what a call may pass.
struct Argument {
  std::string name, about, example;
};

Argument surface_argument(const std::string& input) {
  const std::string name = identifier_of(input, kDialect);
  if (input == "position") return {name, "of the surface, world space", name};
  if (input == "normal") return {name, "of the surface, world space, as interpolated", name};
  if (input == "texture") {
    return {name, "r'g'b' of the texture as it is in the file: no decoding", "<0.7, 0.5, 0.3>"};
  }
  return {name, "the texture on the axes of the space: brightness, chroma", "<0.5, 0.1, 0.0>"};
}

/// The name of the value that the scene had, which the include file declares.
std::string scene_value_name(const Shader& shader, const ShaderParameter& parameter) {
  return fmt::format("{}_{}", identifier_of(shader.function, kDialect),
                     parameter_identifier(parameter.name, kDialect));
}

Argument parameter_argument(const Shader& shader, const ShaderParameter& parameter) {
  const ParameterInfo info = parameter_info(parameter.name);
  const Interval<double> range = range_of(parameter);
  return {parameter_identifier(parameter.name, kDialect),
          fmt::format("{} ({}), {} to {}", info.meaning, info.unit, range.min, range.max),
          scene_value_name(shader, parameter)};
}

std::vector<Argument> arguments_of(const Shader& shader) {
  std::vector<Argument> arguments;
  for (const ShaderFunction::Input& input : color_function(shader).inputs) {
    arguments.push_back(surface_argument(input.name));
  }
  for (const ShaderParameter& parameter : shader.fragment.parameters) {
    arguments.push_back(parameter_argument(shader, parameter));
  }
  return arguments;
}

std::string joined(const std::vector<Argument>& arguments, std::string Argument::* member) {
  std::vector<std::string_view> parts;
  parts.reserve(arguments.size());
  for (const Argument& argument : arguments) parts.push_back(argument.*member);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// `text` with "// " before each line.
std::string commented(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    result += fmt::format("//   {}\n", text.substr(at, end - at));
    at = end + 1;
  }
  return result;
}

/// A whole scene: a triangle lit at its corners.
std::string example(const Shader& shader, const std::string& macro,
                    const std::vector<Argument>& arguments) {
  const std::string call = wrapped_line(
      fmt::format("pigment {{ rgb {}({}) }}", macro, joined(arguments, &Argument::example)),
      "    ");
  return fmt::format(
      "#version 3.7;\n"
      "global_settings {{ assumed_gamma 1.0 }}\n"
      "#include \"{}.inc\"\n"
      "#macro Corner(Position, Normal)\n"
      "  texture {{\n{}    finish {{ ambient 0 diffuse 0 emission 1 }}\n  }}\n"
      "#end\n"
      "#declare A = <-1, 0, 0>;  #declare B = <1, 0, 0>;  #declare C = <0, 0, 1>;\n"
      "mesh2 {{\n"
      "  vertex_vectors {{ 3 A, B, C }}\n"
      "  texture_list {{ 3 Corner(A, -y) Corner(B, -y) Corner(C, -y) }}\n"
      "  face_indices {{ 1 <0, 1, 2>, 0, 1, 2 }}\n"
      "}}\n"
      "camera {{ location <0, -3, 0.5> sky z look_at <0, 0, 0.5> }}\n",
      shader.name, call);
}

/// The numbers of the scene, under names that a call can pass.
std::string scene_values(const Shader& shader) {
  std::string text;
  for (const ShaderParameter& p : shader.fragment.parameters) {
    text += fmt::format("#declare {} = {};\n", scene_value_name(shader, p), literal(p, kDialect));
  }
  return text.empty() ? "" : "// The numbers of the scene that this was made from.\n" + text + "\n";
}

std::string macro_text(const Shader& shader, const std::string& macro,
                       const std::vector<Argument>& arguments) {
  const PrintedCode code = print_code({shader.recorded.color}, kDialect, "  ");
  std::string text = "// r'g'b', not limited to [0, 1].\n";
  for (const Argument& a : arguments) text += wrapped_line(a.name + ": " + a.about, "//   ");
  text += wrapped_line(fmt::format("#macro {}({})", macro, joined(arguments, &Argument::name)), "");
  return text + code.statements + wrapped_line(fmt::format("({})", code.results[0]), "  ") +
         "#end\n";
}

/// A macro of POV-Ray 3.7 has no more parameters than these.
constexpr std::size_t kMaxParameters = 55;

std::optional<std::string> shortfall(const Shader& shader) {
  const std::size_t count = arguments_of(shader).size();
  if (count <= kMaxParameters) return std::nullopt;
  return fmt::format(
      "{} needs {} parameters, and a macro of POV-Ray has at most {}; nearest: fewer lights",
      shader.name, count, kMaxParameters);
}

/// POV-Ray's lighting is fixed, but its scene language computes while a scene is read. So a shader
/// becomes a macro of that language, in double: for lit colours at the corners of a mesh, or to
/// compare with what POV-Ray's own lighting draws.
std::vector<EmittedFile> emit(const Shader& shader) {
  assert(shader.recorded.varyings.empty());  // a macro knows no vertices
  const std::string macro = identifier_of(shader.function, kDialect);
  const std::vector<Argument> arguments = arguments_of(shader);
  const std::string body = macro_text(shader, macro, arguments);
  const std::string text = fmt::format(
      "// {0}. For POV-Ray 3.7: a macro that computes a lit colour.\n"
      "// A scene that bakes the colour into the corners of a triangle:\n//\n{1}\n"
      "#ifndef({2}_Inc)\n#declare {2}_Inc = version;\n#version 3.7;\n\n"
      "{3}{4}{5}\n#version {2}_Inc;\n#end\n",
      about_of(shader), commented(example(shader, macro, arguments)), macro,
      helpers_text(body, kDialect), scene_values(shader), body);
  return {{shader.name + ".inc", text}};
}

}  // namespace
}  // namespace lumaknot::pov

namespace lumaknot {

extern const Backend kPovBackend{.name = "pov",
                                 .about = "POV-Ray 3.7, an include file with a macro",
                                 .dialect = &pov::kDialect,
                                 .emit = pov::emit,
                                 .shortfall = pov::shortfall};

}  // namespace lumaknot
