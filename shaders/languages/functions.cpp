#include "shaders/languages/functions.h"

#include <fmt/format.h>

namespace lumaknot {
namespace {

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

}  // namespace

std::vector<ShaderFunction> varying_functions(const Shader& shader) {
  std::vector<ShaderFunction> functions;
  functions.reserve(shader.recorded.varyings.size());
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
    if (!inputs.empty()) inputs += ", ";
    inputs += fmt::format(fmt::runtime(dialect.input), fmt::arg("type", type(input.is_vector)),
                          fmt::arg("name", identifier_of(input.name, dialect)));
  }
  const PrintedCode code = print_code({function.result}, dialect, "  ");
  const std::string returned = wrapped_line(fmt::format("return {};", code.results[0]), "  ");
  return fmt::format(fmt::runtime(dialect.function),
                     fmt::arg("type", type(function.result->is_vector)),
                     fmt::arg("name", identifier_of(function.name, dialect)),
                     fmt::arg("inputs", inputs), fmt::arg("body", code.statements + returned));
}

std::string helpers_text(const std::string& code, const Dialect& dialect) {
  std::string text;
  for (const Helper& helper : dialect.helpers) {
    if (code.find(fmt::format("{}(", helper.name)) != code.npos) text += helper.text;
  }
  return text;
}

}  // namespace lumaknot
