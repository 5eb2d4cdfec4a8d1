#include <fmt/format.h>

#include "shaders/languages/common.h"
#include "shaders/languages/reserved_words.h"

namespace lumaknot::glsl {
namespace {

constexpr Helper kHelpers[] = {kSafePower,
                               {"safe_normalize",
                                "// Zero stays zero.\n"
                                "vec3 safe_normalize(vec3 v) {\n"
                                "  return v * inversesqrt(max(dot(v, v), 1e-36));\n"
                                "}\n\n"}};

/// Of every version.
constexpr Dialect kDialect{.scalar_type = "float",
                           .vector_type = "vec3",
                           .uv_type = "vec2",
                           .vector_of = "vec3({0}, {1}, {2})",
                           .grey_of = "vec3({0})",
                           .component = {"{0}.x", "{0}.y", "{0}.z"},
                           .saturate = "clamp({0}, 0.0, 1.0)",
                           .vector_saturate = "clamp({0}, 0.0, 1.0)",
                           .helpers = kHelpers,
                           .reserved = kGlslWords};

/// How the versions differ.
struct Version {
  std::string_view header;
  bool has_defaults = false;  ///< uniforms may have initial values
  bool is_vulkan = false;     ///< a uniform block; numbered varyings and bindings
};

constexpr std::string_view kEsHeader =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

constexpr Version kVersion330{.header = "#version 330 core\n", .has_defaults = true};
constexpr Version kVersionEs300{.header = kEsHeader};
constexpr Version kVersion450{.header = "#version 450\n", .is_vulkan = true};

std::string id(std::string_view name) { return parameter_identifier(name, kDialect); }

std::string_view type_of(bool is_vector) { return is_vector ? "vec3" : "float"; }

std::string uniforms(const Version& version, const std::vector<ShaderParameter>& parameters) {
  std::string text;
  for (const ShaderParameter& p : parameters) {
    const std::string value =
        version.has_defaults ? fmt::format(" = {}", literal(p, kDialect)) : "";
    text += fmt::format("uniform {} {}{};  {}\n", type_of(p.is_vector), id(p.name), value,
                        comment_of(p.name));
  }
  return text;
}

constexpr std::string_view kMatrices[] = {"world", "world_inverse_transpose",
                                          "world_view_projection"};

/// Both stages of Vulkan share one block.
std::string block(const Shader& shader) {
  std::string text = "layout(set = 0, binding = 0, std140) uniform Parameters {\n";
  for (const std::string_view matrix : kMatrices) text += fmt::format("  mat4 {};\n", matrix);
  for (const ShaderParameter& p : shader.parameters) {
    text += fmt::format("  {} {};  {}\n", type_of(p.is_vector), id(p.name), comment_of(p.name));
  }
  return text + "};\n";
}

std::string declared(const Version& version, const Shader& shader, std::string_view direction) {
  std::string text;
  int location = 0;
  for (const StageLink& link : stage_links(shader, kDialect)) {
    if (version.is_vulkan) text += fmt::format("layout(location = {}) ", location++);
    text += fmt::format("{} {} surface_{};\n", direction, link.type, link.name);
  }
  return text;
}

/// The expression in a stage's main() for an input of a function.
std::string argument(const ShaderFunction::Input& input, const Shader& shader) {
  if (input.name.starts_with("texture")) {
    return fmt::format("texture({}, surface_uv).rgb", texture_name(shader));
  }
  return fmt::format("surface_{}", input.name);
}

std::string call(const ShaderFunction& function, const Shader& shader) {
  return call_text(function, kDialect, [&](const auto& i) { return argument(i, shader); });
}

std::string vertex_main(const Shader& shader) {
  const bool linked_position = shader.fragment.position, linked_normal = shader.fragment.normal;
  std::string text = "void main() {\n";
  if (linked_position || shader.vertex.position) {
    text += fmt::format("  {}surface_position = (world * vec4(vertex_position, 1.0)).xyz;\n",
                        linked_position ? "" : "vec3 ");
  }
  if (linked_normal || shader.vertex.normal) {
    text += fmt::format(
        "  {}surface_normal =\n      safe_normalize((world_inverse_transpose * vec4(vertex_normal, "
        "0.0)).xyz);\n",
        linked_normal ? "" : "vec3 ");
  }
  if (shader.textured()) text += "  surface_uv = vertex_uv;\n";
  for (const ShaderFunction& function : varying_functions(shader)) {
    const std::string name = varying_of(function);
    text += fmt::format("  surface_{} = {};\n", name, call(function, shader));
  }
  return text + "  gl_Position = world_view_projection * vec4(vertex_position, 1.0);\n}\n";
}

std::string vertex_stage(const Version& version, const Shader& shader) {
  const bool reads_normal = shader.fragment.normal || shader.vertex.normal;
  const bool reads_position = shader.fragment.position || shader.vertex.position;
  std::string text = fmt::format("{}// Vertex stage of {}.\n\n", version.header, about_of(shader));
  text += "layout(location = 0) in vec3 vertex_position;\n";
  if (reads_normal) text += "layout(location = 1) in vec3 vertex_normal;\n";
  if (shader.textured()) text += "layout(location = 2) in vec2 vertex_uv;\n";
  text += "\n";
  if (version.is_vulkan) {
    text += block(shader);
  } else {
    if (reads_position) text += "uniform mat4 world;\n";
    if (reads_normal) text += "uniform mat4 world_inverse_transpose;\n";
    text += "uniform mat4 world_view_projection;\n";
    text += uniforms(version, shader.vertex.parameters);
  }
  text += fmt::format("\n{}\n", declared(version, shader, "out"));
  return text + with_helpers(vertex_functions(shader, kDialect) + vertex_main(shader), kDialect);
}

std::string fragment_stage(const Version& version, const Shader& shader) {
  std::string text =
      fmt::format("{}// Fragment stage of {}.\n\n", version.header, about_of(shader));
  text += declared(version, shader, "in") + "\n";
  text += version.is_vulkan ? block(shader) : uniforms(version, shader.fragment.parameters);
  if (shader.textured()) {
    const std::string binding = fmt::format("layout(set = 0, binding = {}) ", shader.baked ? 2 : 1);
    text += fmt::format("{}uniform sampler2D {};  {}\n", version.is_vulkan ? binding : "",
                        texture_name(shader), comment_of(texture_name(shader)));
  }
  text += fmt::format("\n{}out vec4 fragment_color;\n\n",
                      version.is_vulkan ? "layout(location = 0) " : "");
  const std::string result =
      fmt::format("fragment_color = vec4({}, 1.0);", call(color_function(shader), shader));
  return text + with_helpers(function_text(color_function(shader), kDialect), kDialect) +
         fmt::format("\nvoid main() {{\n{}}}\n", wrapped_line(result, "  "));
}

/// A triangle that covers the image.
std::string kernel_vertex(const Version& version) {
  return fmt::format(
      "{}void main() {{\n"
      "  int corner = {};\n"
      "  gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}}\n",
      version.header, version.is_vulkan ? "gl_VertexIndex" : "gl_VertexID");
}

template <const Version& version>
std::vector<EmittedFile> emit(const Shader& shader) {
  return {{shader.name + ".vert", vertex_stage(version, shader)},
          {shader.name + ".frag", fragment_stage(version, shader)}};
}

template <const Version& version>
KernelCode kernel(const Shader& shader) {
  // The image's first row is the top one; OpenGL counts from the bottom.
  const std::string_view row =
      version.is_vulkan ? "int(gl_FragCoord.y)" : "63 - int(gl_FragCoord.y)";
  std::string text =
      fmt::format("{}{}uniform sampler2D inputs;\n{}out vec4 fragment_color;\n\n", version.header,
                  version.is_vulkan ? "layout(set = 0, binding = 1) " : "",
                  version.is_vulkan ? "layout(location = 0) " : "");
  for (const ShaderParameter& p : shader.parameters) {
    text += fmt::format("{} {};\n", type_of(p.is_vector), id(p.name));
  }
  text += "\n";
  text += with_helpers(
      vertex_functions(shader, kDialect) + function_text(color_function(shader), kDialect),
      kDialect);
  text += fmt::format("\nvoid main() {{\n  int index = ({}) * 64 + int(gl_FragCoord.x);\n", row);
  int line = 0;
  for (const KernelInput& input : kernel_inputs(shader)) {
    const bool is_parameter = line >= 3;
    text += fmt::format("  {}{} = texelFetch(inputs, ivec2(index, {}), 0).{};\n",
                        is_parameter ? "" : "vec3 kernel_", line < 3 ? input.name : id(input.name),
                        line, input.is_vector ? "xyz" : "x");
    ++line;
  }
  text += wrapped_line(
      fmt::format("fragment_color = vec4({}, 1.0);", kernel_call(shader, kDialect)), "  ");
  return {kernel_vertex(version), text + "}\n"};
}

}  // namespace
}  // namespace lumaknot::glsl

namespace lumaknot {

extern const Backend kGlsl330Backend{.name = "glsl-330",
                                     .about = "OpenGL 3.3 core",
                                     .dialect = &glsl::kDialect,
                                     .emit = glsl::emit<glsl::kVersion330>,
                                     .has_vertex_stage = true,
                                     .api = "gl",
                                     .kernel = glsl::kernel<glsl::kVersion330>};

extern const Backend kGlslEs300Backend{.name = "glsl-es-300",
                                       .about = "OpenGL ES 3.0 and WebGL 2",
                                       .dialect = &glsl::kDialect,
                                       .emit = glsl::emit<glsl::kVersionEs300>,
                                       .has_vertex_stage = true,
                                       .api = "gles",
                                       .kernel = glsl::kernel<glsl::kVersionEs300>};

extern const Backend kGlsl450Backend{.name = "glsl-450",
                                     .about = "Vulkan",
                                     .dialect = &glsl::kDialect,
                                     .emit = glsl::emit<glsl::kVersion450>,
                                     .has_vertex_stage = true,
                                     .has_block = true,
                                     .api = "vulkan",
                                     .kernel = glsl::kernel<glsl::kVersion450>};

}  // namespace lumaknot
