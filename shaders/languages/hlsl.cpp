#include "shaders/languages/hlsl.h"

#include <fmt/format.h>

namespace lumaknot::hlsl {
namespace {

constexpr Dialect kDialect = kHlslDialect;

std::string id(std::string_view name) { return parameter_identifier(name, kDialect); }

std::string_view type_of(bool is_vector) { return is_vector ? "float3" : "float"; }

std::string constant_buffer(const Shader& shader) {
  std::string text = "cbuffer Parameters : register(b0) {\n";
  for (const char* matrix : {"world", "world_inverse_transpose", "world_view_projection"}) {
    text += fmt::format("  column_major float4x4 {};\n", matrix);
  }
  for (const ShaderParameter& p : shader.parameters) {
    text += fmt::format("  {} {};  {}\n", type_of(p.is_vector), id(p.name), comment_of(p.name));
  }
  return text + "};\n\n";
}

std::string structures(const Shader& shader) {
  std::string text =
      "struct Vertex {\n"
      "  float3 position : POSITION;\n"
      "  float3 normal : NORMAL;\n"
      "  float2 uv : TEXCOORD0;\n"
      "};\n\n"
      "struct Surface {\n"
      "  float4 clip_position : SV_Position;\n";
  int index = 0;
  for (const StageLink& link : stage_links(shader, kDialect)) {
    text += fmt::format("  {} {} : TEXCOORD{};\n", link.type, link.name, index++);
  }
  return text + "};\n\n";
}

std::string sampled(const Shader& shader) {
  const std::string_view name = texture_name(shader);
  return fmt::format("{}.Sample({}_sampler, surface.uv).rgb", name,
                     name.substr(0, name.find("_texture")));
}

std::string argument(const ShaderFunction::Input& input, const Shader& shader,
                     std::string_view surface) {
  if (input.name.starts_with("texture")) return sampled(shader);
  return fmt::format("{}{}", surface, input.name);
}

std::string vertex_main(const Shader& shader) {
  std::string text = "Surface vertex_main(Vertex vertex) {\n  Surface surface;\n";
  if (shader.fragment.position || shader.vertex.position) {
    text += "  float3 position = mul(world, float4(vertex.position, 1.0)).xyz;\n";
  }
  if (shader.fragment.normal || shader.vertex.normal) {
    text +=
        "  float3 normal =\n"
        "      safe_normalize(mul(world_inverse_transpose, float4(vertex.normal, 0.0)).xyz);\n";
  }
  if (shader.fragment.position) text += "  surface.position = position;\n";
  if (shader.fragment.normal) text += "  surface.normal = normal;\n";
  if (shader.textured()) text += "  surface.uv = vertex.uv;\n";
  for (const ShaderFunction& function : varying_functions(shader)) {
    const std::string call = call_text(
        function, kDialect, [&](const auto& input) { return argument(input, shader, ""); });
    text += fmt::format("  surface.{} = {};\n", varying_of(function), call);
  }
  return text +
         "  surface.clip_position = mul(world_view_projection, float4(vertex.position, 1.0));\n"
         "  return surface;\n}\n";
}

std::string fragment_main(const Shader& shader) {
  const std::string call = call_text(color_function(shader), kDialect, [&](const auto& input) {
    return argument(input, shader, "surface.");
  });
  return fmt::format("float4 fragment_main(Surface surface) : SV_Target {{\n{}}}\n",
                     wrapped_line(fmt::format("return float4({}, 1.0);", call), "  "));
}

std::string texture_declaration(const Shader& shader) {
  if (!shader.textured()) return "";
  const std::string_view name = texture_name(shader);
  return fmt::format(
      "Texture2D {0} : register(t{3});  {2}\nSamplerState {1}_sampler : register(s{3});\n\n", name,
      name.substr(0, name.find("_texture")), comment_of(name), shader.baked ? 1 : 0);
}

std::vector<EmittedFile> emit(const Shader& shader) {
  const std::string code = vertex_functions(shader, kDialect) +
                           function_text(color_function(shader), kDialect) + "\n" +
                           vertex_main(shader) + "\n" + fragment_main(shader);
  return {
      {shader.name + ".hlsl",
       fmt::format("// {}.\n// Entry points: vertex_main (vs_5_0, vs_6_0), fragment_main (ps_5_0, "
                   "ps_6_0).\n\n",
                   about_of(shader)) +
           constant_buffer(shader) + texture_declaration(shader) + structures(shader) +
           with_helpers(code, kDialect)}};
}

KernelCode kernel(const Shader& shader) {
  std::string text = "Texture2D inputs : register(t0);\n\n";
  for (const ShaderParameter& p : shader.parameters) {
    text += fmt::format("static {} {};\n", type_of(p.is_vector), id(p.name));
  }
  text += "\n";
  text += with_helpers(
      vertex_functions(shader, kDialect) + function_text(color_function(shader), kDialect),
      kDialect);
  text +=
      "\nfloat4 vertex_main(uint corner : SV_VertexID) : SV_Position {\n"
      "  return float4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n"
      "\nfloat4 fragment_main(float4 place : SV_Position) : SV_Target {\n"
      "  int index = int(place.y) * 64 + int(place.x);\n";
  int line = 0;
  for (const KernelInput& input : kernel_inputs(shader)) {
    text += fmt::format("  {}{} = inputs.Load(int3(index, {}, 0)).{};\n",
                        line < 3 ? "float3 kernel_" : "", line < 3 ? input.name : id(input.name),
                        line, input.is_vector ? "xyz" : "x");
    ++line;
  }
  text +=
      wrapped_line(fmt::format("return float4({}, 1.0);", kernel_call(shader, kDialect)), "  ") +
      "}\n";
  return {text, text};
}

}  // namespace
}  // namespace lumaknot::hlsl

namespace lumaknot {

extern const Backend kHlslBackend{.name = "hlsl",
                                  .about = "Direct3D 11 and 12, shader model 5 and 6",
                                  .dialect = &hlsl::kDialect,
                                  .emit = hlsl::emit,
                                  .has_vertex_stage = true,
                                  .has_block = true,
                                  .api = "vulkan",
                                  .kernel = hlsl::kernel};

}  // namespace lumaknot
