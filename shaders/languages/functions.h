/// The functions of a shader, printed.
#pragma once

#include <fmt/format.h>

#include <string>

#include "shaders/graph/shader.h"
#include "shaders/languages/code_printer.h"

namespace lumaknot {

/// A function of a shader: the colour, or one varying.
struct ShaderFunction {
  struct Input {
    std::string name;  ///< position, normal, texture, texture_axes, diffuse_light, specular_light
    bool is_vector = true;
  };
  std::string name;
  NodePtr result;
  std::vector<Input> inputs;
};

/// The functions of the varyings, in their order, named diffuse_light_at, specular_light_at.
std::vector<ShaderFunction> varying_functions(const Shader& shader);
ShaderFunction color_function(const Shader& shader);

/// `function` as a definition, its parameters global.
std::string function_text(const ShaderFunction& function, const Dialect& dialect);

/// The helper functions of the dialect that `code` calls.
std::string helpers_text(const std::string& code, const Dialect& dialect);

/// The call of `function` with the expression that `argument(input)` gives for each input.
template <class F>
std::string call_text(const ShaderFunction& function, const Dialect& dialect, F argument) {
  std::string text;
  for (const ShaderFunction::Input& input : function.inputs) {
    if (!text.empty()) text += ", ";
    text += argument(input);
  }
  return fmt::format("{}({})", identifier_of(function.name, dialect), text);
}

}  // namespace lumaknot
