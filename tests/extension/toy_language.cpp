// A language in one file: functions as in WGSL, no vertex stage.
#include <fmt/format.h>

#include "shaders/languages/common.h"

namespace lumaknot::toy {
namespace {

constexpr Helper kHelpers[] = {
    {"safe_power",
     "fn safe_power(base: f32, exponent: f32) -> f32 {\n"
     "  return select(select(1.0, 0.0, exponent > 0.0), pow(base, exponent), base > 0.0);\n"
     "}\n\n"},
    {"safe_normalize",
     "fn safe_normalize(v: vec3f) -> vec3f {\n"
     "  return v * inverseSqrt(max(dot(v, v), 1e-36));\n"
     "}\n\n"}};

constexpr Dialect kDialect{.scalar_type = "f32",
                           .vector_type = "vec3f",
                           .declaration = "let {name}: {type} = {value};",
                           .input = "{name}: {type}",
                           .function = "fn {name}({inputs}) -> {type} {{\n{body}}}\n",
                           .select = "select({3}, {2}, {0} < {1})",
                           .vector_of = "vec3f({0}, {1}, {2})",
                           .grey_of = "vec3f({0})",
                           .component = {"{0}.x", "{0}.y", "{0}.z"},
                           .saturate = "saturate({0})",
                           .vector_saturate = "saturate({0})",
                           .helpers = kHelpers,
                           .reserved = {}};

std::vector<EmittedFile> emit(const Shader& shader) {
  std::string text;
  for (const ShaderParameter& p : shader.fragment.parameters) {
    text += fmt::format("const {} = {};\n", parameter_identifier(p.name, kDialect),
                        literal(p, kDialect));
  }
  text += "\n" + with_helpers(function_text(color_function(shader), kDialect), kDialect);
  return {{shader.name + ".toy", text}};
}

}  // namespace
}  // namespace lumaknot::toy

namespace lumaknot {

extern const Backend kToyBackend{
    .name = "toy", .about = "a test", .dialect = &toy::kDialect, .emit = toy::emit};

}  // namespace lumaknot
