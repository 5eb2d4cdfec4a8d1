#include <fmt/format.h>

#include "shaders/languages/common.h"
#include "shaders/languages/reserved_words.h"

namespace lumaknot::osl {
namespace {

constexpr Helper kHelpers[] = {kSafePower,
                               {"safe_normalize",
                                "// Zero stays zero.\n"
                                "vector safe_normalize(vector v) {\n"
                                "  return v * inversesqrt(max(dot(v, v), 1e-36));\n"
                                "}\n\n"}};

constexpr Dialect kDialect{.scalar_type = "float",
                           .vector_type = "vector",
                           .vector_of = "vector({0}, {1}, {2})",
                           .grey_of = "vector({0})",
                           .component = {"{0}[0]", "{0}[1]", "{0}[2]"},
                           .saturate = "clamp({0}, 0.0, 1.0)",
                           .vector_saturate = "clamp({0}, vector(0.0), vector(1.0))",
                           .helpers = kHelpers,
                           .reserved = kOslWords};

std::string metadata(const ShaderParameter& p) {
  const ParameterInfo info = parameter_info(p.name);
  std::string text = fmt::format("[[ string help = \"{} ({})\"", info.meaning, info.unit);
  if (!p.is_vector) {
    const Interval<double> range = range_of(p);
    text += fmt::format(", float min = {}, float max = {}", number_text(range.min),
                        number_text(range.max));
  }
  return text + " ]]";
}

/// A surface's value as a parameter, so that other nodes can feed it; nothing is transformed.
std::string surface_input(const ShaderFunction::Input& input) {
  const std::string name = identifier_of(input.name, kDialect);
  if (input.name == "position")
    return "    vector position = P [[ string help = \"world space\" ]]";
  if (input.name == "normal") {
    return "    vector normal_value = N [[ string help = \"world space, as interpolated\" ]]";
  }
  return fmt::format("    vector {} = vector(0.7) [[ string help = \"{}\" ]]", name,
                     input.name == "texture" ? "r'g'b' of the texture, not decoded"
                                             : "the texture on the axes of the space");
}

std::vector<EmittedFile> emit(const Shader& shader) {
  const ShaderFunction function = color_function(shader);
  std::vector<std::string> parameters;
  parameters.reserve(function.inputs.size() + shader.fragment.parameters.size());
  for (const ShaderFunction::Input& input : function.inputs) {
    parameters.push_back(surface_input(input));
  }
  for (const ShaderParameter& p : shader.fragment.parameters) {
    parameters.push_back(fmt::format("    {} {} = {}\n        {}", p.is_vector ? "vector" : "float",
                                     parameter_identifier(p.name, kDialect), literal(p, kDialect),
                                     metadata(p)));
  }
  parameters.push_back(
      "    output vector result = vector(0.0) [[ string help = \"r'g'b', for an emission\" ]]");
  std::string list;
  for (const std::string& p : parameters) list += fmt::format("{}{}", list.empty() ? "" : ",\n", p);
  const PrintedCode code = print_code({function.result}, kDialect, "  ");
  const std::string body =
      code.statements + wrapped_line(fmt::format("result = {};", code.results[0]), "  ");
  return {
      {shader.name + ".osl", fmt::format("// {}.\n\n{}shader {}(\n{})\n{{\n{}}}\n",
                                         about_of(shader), helpers_text(body, kDialect),
                                         identifier_of(shader.function, kDialect), list, body)}};
}

}  // namespace
}  // namespace lumaknot::osl

namespace lumaknot {

extern const Backend kOslBackend{.name = "osl",
                                 .about = "Open Shading Language, for an emission",
                                 .dialect = &osl::kDialect,
                                 .emit = osl::emit};

}  // namespace lumaknot
