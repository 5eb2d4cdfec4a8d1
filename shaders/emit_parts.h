/// What the emitters of the languages share.
#pragma once

#include "shaders/dialects.h"
#include "shaders/emit.h"
#include "shaders/parameters.h"

namespace lumaknot {

/// "// the eye, world space (scene units)" for the parameter of that name.
std::string comment_of(std::string_view name);

/// `value` as a literal of the dialect.
std::string literal(const ShaderParameter& parameter, const Dialect& dialect);

/// The range of a parameter, widened where its value now lies outside.
struct ParameterRange {
  double least, most;
};
ParameterRange range_of(const ShaderParameter& parameter);

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

/// Says so when Direct3D 9 has too few instruction slots for the shader.
std::optional<std::string> fx_shortfall(const Shader& shader);

std::vector<EmittedFile> emit_glsl(const Shader& shader, Language language);
std::vector<EmittedFile> emit_hlsl(const Shader& shader);
std::vector<EmittedFile> emit_fx(const Shader& shader);
std::vector<EmittedFile> emit_osl(const Shader& shader);
std::vector<EmittedFile> emit_blender(const Shader& shader);

KernelCode glsl_kernel(const Shader& shader, Language language);
KernelCode hlsl_kernel(const Shader& shader);

}  // namespace lumaknot
