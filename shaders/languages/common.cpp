#include "shaders/languages/common.h"

#include <fmt/format.h>

#include <algorithm>

namespace lumaknot {

std::string comment_of(std::string_view name) {
  const ParameterInfo info = parameter_info(name);
  return fmt::format("// {} ({})", info.meaning, info.unit);
}

std::string literal(const ShaderParameter& parameter, const Dialect& dialect) {
  const Vec3d& v = parameter.value;
  if (!parameter.is_vector) return number_text(v.x);
  return fmt::format(fmt::runtime(dialect.vector_of), number_text(v.x), number_text(v.y),
                     number_text(v.z));
}

Interval<double> range_of(const ShaderParameter& parameter) {
  const ParameterInfo info = parameter_info(parameter.name);
  const auto [x, y, z] = components(parameter.value);
  if (!parameter.is_vector) return {std::min(info.min, x), std::max(info.max, x)};
  return {std::min({info.min, x, y, z}), std::max({info.max, x, y, z})};
}

std::string vertex_functions(const Shader& shader, const Dialect& dialect) {
  std::string text;
  for (const ShaderFunction& function : varying_functions(shader)) {
    text += function_text(function, dialect) + "\n";
  }
  return text;
}

std::string with_helpers(const std::string& code, const Dialect& dialect) {
  return helpers_text(code, dialect) + code;
}

std::string kernel_call(const Shader& shader, const Dialect& dialect) {
  const std::vector<ShaderFunction> varyings = varying_functions(shader);
  const auto plain = [](const ShaderFunction::Input& input) {
    return input.name.starts_with("texture") ? "kernel_texture" : "kernel_" + input.name;
  };
  return call_text(color_function(shader), dialect, [&](const ShaderFunction::Input& input) {
    for (const ShaderFunction& varying : varyings) {
      if (varying.name == input.name + "_at") return call_text(varying, dialect, plain);
    }
    return plain(input);
  });
}

std::vector<StageLink> stage_links(const Shader& shader, const Dialect& dialect) {
  const std::string vec3(dialect.vector_type), scalar(dialect.scalar_type);
  std::vector<StageLink> links;
  if (shader.fragment.position) links.push_back({vec3, "position"});
  if (shader.fragment.normal) links.push_back({vec3, "normal"});
  if (shader.textured()) links.push_back({std::string(dialect.uv_type), "uv"});
  for (const Varying& varying : shader.recorded.varyings) {
    links.push_back({varying.value->is_vector ? vec3 : scalar, varying.name});
  }
  return links;
}

std::string varying_of(const ShaderFunction& function) {
  return function.name.substr(0, function.name.rfind("_at"));
}

std::string_view texture_name(const Shader& shader) {
  return shader.baked ? "axes_texture" : "color_texture";
}

std::string about_of(const Shader& shader) {
  return fmt::format("{}, made by lumaknot", shader.name);
}

}  // namespace lumaknot
