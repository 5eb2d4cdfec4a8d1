#include "shaders/dialects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "shaders/reserved_words.h"

namespace lumaknot {
namespace {

/// The paper's names in Table 1; others as it would have named them.
std::string fx_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kTable1{
      {{"eye_position", "EyePos"},
       {"light_position", "LightPos"},
       {"ambient", "AmbientValue"},
       {"shininess", "SpecularPower"},
       {"color_texture", "ColorTexture"}}};
  const auto found =
      std::ranges::find(kTable1, name, &std::pair<std::string_view, std::string_view>::first);
  if (found != kTable1.end()) return std::string(found->second);
  std::string result;
  bool starts = true;
  for (const unsigned char c : name) {
    if (c != '_') result += char(starts ? std::toupper(c) : c);
    starts = c == '_';
  }
  return result;
}

constexpr Dialect glsl() {
  return {.scalar_type = "float",
          .vector_type = "vec3",
          .declaration = "{type} {name} = {value};",
          .vector_of = "vec3({0}, {1}, {2})",
          .grey_of = "vec3({0})",
          .component = {"{0}.x", "{0}.y", "{0}.z"},
          .saturate = "clamp({0}, 0.0, 1.0)",
          .vector_saturate = "clamp({0}, 0.0, 1.0)",
          .reserved = kGlslWords};
}

constexpr Dialect hlsl() {
  Dialect dialect = glsl();
  dialect.vector_type = "float3";
  dialect.vector_of = "float3({0}, {1}, {2})";
  dialect.grey_of = "float3({0}, {0}, {0})";
  dialect.saturate = dialect.vector_saturate = "saturate({0})";
  dialect.reserved = kHlslWords;
  return dialect;
}

constexpr Dialect fx() {
  Dialect dialect = hlsl();
  dialect.parameter_name = fx_name;
  return dialect;
}

constexpr Dialect osl() {
  Dialect dialect = glsl();
  dialect.vector_type = "vector";
  dialect.vector_of = "vector({0}, {1}, {2})";
  dialect.grey_of = "vector({0})";
  dialect.component[0] = "{0}[0]";
  dialect.component[1] = "{0}[1]";
  dialect.component[2] = "{0}[2]";
  dialect.vector_saturate = "clamp({0}, vector(0.0), vector(1.0))";
  dialect.reserved = kOslWords;
  return dialect;
}

/// The inputs of `root`, in an order that all languages share.
std::vector<ShaderFunction::Input> inputs_of(const NodePtr& root) {
  constexpr std::string_view kOrder[] = {"position",     "normal",        "texture",
                                         "texture_axes", "diffuse_light", "specular_light"};
  std::vector<ShaderFunction::Input> inputs;
  const std::vector<const Node*> nodes = in_order({root});
  for (const std::string_view name : kOrder) {
    for (const Node* node : nodes) {
      if (node->op != Op::kInput || node->name != name) continue;
      inputs.push_back({node->name, node->is_vector});
      break;
    }
  }
  return inputs;
}

struct Helper {
  std::string_view name, text;
};

/// `{0}` is the vector type. Powers of zero and unit vectors of zero, which languages leave open.
constexpr Helper kHelpers[] = {
    {"safe_power",
     "// base >= 0; 0 to the power 0 is 1.\n"
     "float safe_power(float base, float exponent) {{\n"
     "  return base > 0.0 ? pow(base, exponent) : (exponent > 0.0 ? 0.0 : 1.0);\n"
     "}}\n\n"},
    {"safe_normalize",
     "// Zero stays zero.\n"
     "{0} safe_normalize({0} v) {{\n"
     "  return v * {1}(max(dot(v, v), 1e-36));\n"
     "}}\n\n"}};

}  // namespace

constinit const Dialect kGlslDialect = glsl();
constinit const Dialect kHlslDialect = hlsl();
constinit const Dialect kFxDialect = fx();
constinit const Dialect kOslDialect = osl();

std::vector<ShaderFunction> varying_functions(const Shader& shader) {
  std::vector<ShaderFunction> functions;
  for (const Varying& varying : shader.recorded.varyings) {
    functions.push_back({varying.name + "_at", varying.value, inputs_of(varying.value)});
  }
  return functions;
}

ShaderFunction color_function(const Shader& shader) {
  return {shader.function, shader.recorded.color, inputs_of(shader.recorded.color)};
}

std::string function_text(const ShaderFunction& function, const Dialect& dialect) {
  const auto type = [&](bool is_vector) {
    return is_vector ? dialect.vector_type : dialect.scalar_type;
  };
  std::string inputs;
  for (const ShaderFunction::Input& input : function.inputs) {
    inputs += fmt::format("{}{} {}", inputs.empty() ? "" : ", ", type(input.is_vector),
                          identifier_of(input.name, dialect));
  }
  const PrintedCode code = print_code({function.result}, dialect, "  ");
  return fmt::format("{} {}({}) {{\n{}{}}}\n", type(function.result->is_vector),
                     identifier_of(function.name, dialect), inputs, code.statements,
                     wrapped_line(fmt::format("return {};", code.results[0]), "  "));
}

std::string helpers_text(const std::string& code, const Dialect& dialect) {
  const bool is_hlsl = dialect.vector_type == "float3";
  std::string text;
  for (const Helper& helper : kHelpers) {
    if (code.find(std::string(helper.name) + "(") == code.npos) continue;
    text += fmt::format(fmt::runtime(helper.text), dialect.vector_type,
                        is_hlsl ? "rsqrt" : "inversesqrt");
  }
  return text;
}

}  // namespace lumaknot
