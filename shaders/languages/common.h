/// What the emitters of the languages share.
#pragma once

#include "shaders/graph/parameters.h"
#include "shaders/languages/backend.h"
#include "shaders/languages/emit.h"
#include "shaders/languages/functions.h"

namespace lumaknot {

/// In C-like languages. Powers of zero are what languages leave open.
inline constexpr Helper kSafePower{
    "safe_power",
    "// base >= 0; 0 to the power 0 is 1.\n"
    "float safe_power(float base, float exponent) {\n"
    "  return base > 0.0 ? pow(base, exponent) : (exponent > 0.0 ? 0.0 : 1.0);\n"
    "}\n\n"};

/// "// the eye, world space (scene units)" for the parameter of that name.
std::string comment_of(std::string_view name);

/// `value` as a literal of the dialect.
std::string literal(const ShaderParameter& parameter, const Dialect& dialect);

/// The range of a parameter, widened where its value now lies outside.
Interval<double> range_of(const ShaderParameter& parameter);

/// The definitions of the varyings' functions, a blank line after each.
std::string vertex_functions(const Shader& shader, const Dialect& dialect);

/// `code` after the helper functions that it calls.
std::string with_helpers(const std::string& code, const Dialect& dialect);

/// The call of the colour's function in a kernel, where the surface's values are kernel_position,
/// kernel_normal and kernel_texture.
std::string kernel_call(const Shader& shader, const Dialect& dialect);

/// A value that the fragment stage gets interpolated: position, normal, uv, or a varying.
struct StageLink {
  std::string type;  ///< as the dialect spells it
  std::string name;
};
std::vector<StageLink> stage_links(const Shader& shader, const Dialect& dialect);

/// The functions of the varyings by the names of what they compute.
std::string varying_of(const ShaderFunction& function);

/// "color_texture" or, baked, "axes_texture".
std::string_view texture_name(const Shader& shader);

/// One line on what the shader computes.
std::string about_of(const Shader& shader);

}  // namespace lumaknot
