#include <fmt/format.h>

#include "shaders/emit_parts.h"

namespace lumaknot {
namespace {

std::string metadata(const ShaderParameter& p) {
  const ParameterInfo& info = parameter_info(p.name);
  std::string text = fmt::format("[[ string help = \"{} ({})\"", info.meaning, info.unit);
  if (!p.is_vector) {
    const ParameterRange range = range_of(p);
    text += fmt::format(", float min = {}, float max = {}", number_text(range.least),
                        number_text(range.most));
  }
  return text + " ]]";
}

/// A surface's value as a parameter, so that other nodes can feed it; nothing is transformed.
std::string surface_input(const ShaderFunction::Input& input) {
  const std::string name = identifier_of(input.name, kOslDialect);
  if (input.name == "position")
    return "    vector position = P [[ string help = \"world space\" ]]";
  if (input.name == "normal") {
    return "    vector normal_value = N [[ string help = \"world space, as interpolated\" ]]";
  }
  return fmt::format("    vector {} = vector(0.7) [[ string help = \"{}\" ]]", name,
                     input.name == "texture" ? "r'g'b' of the texture, not decoded"
                                             : "the texture on the axes of the space");
}

}  // namespace

std::vector<EmittedFile> emit_osl(const Shader& shader) {
  const ShaderFunction function = color_function(shader);
  std::vector<std::string> parameters;
  for (const ShaderFunction::Input& input : function.inputs) {
    parameters.push_back(surface_input(input));
  }
  for (const ShaderParameter& p : shader.fragment.parameters) {
    parameters.push_back(fmt::format("    {} {} = {}\n        {}", p.is_vector ? "vector" : "float",
                                     parameter_identifier(p.name, kOslDialect),
                                     literal(p, kOslDialect), metadata(p)));
  }
  parameters.push_back(
      "    output vector result = vector(0.0) [[ string help = \"r'g'b', for an emission\" ]]");
  std::string list;
  for (const std::string& p : parameters) list += fmt::format("{}{}", list.empty() ? "" : ",\n", p);
  const PrintedCode code = print_code({function.result}, kOslDialect, "  ");
  const std::string body =
      code.statements + wrapped_line(fmt::format("result = {};", code.results[0]), "  ");
  return {
      {shader.name + ".osl", fmt::format("// {}.\n\n{}shader {}(\n{})\n{{\n{}}}\n",
                                         about_of(shader), helpers_text(body, kOslDialect),
                                         identifier_of(shader.function, kOslDialect), list, body)}};
}

}  // namespace lumaknot
