/// How the languages of shaders spell formulas.
#pragma once

#include <fmt/format.h>

#include <string>

#include "shaders/code_printer.h"
#include "shaders/shader.h"

namespace lumaknot {

extern const Dialect kGlslDialect;  ///< every version
extern const Dialect kHlslDialect;  ///< shader models 2 to 6
extern const Dialect kFxDialect;    ///< the same, with the paper's names for parameters
extern const Dialect kOslDialect;

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
