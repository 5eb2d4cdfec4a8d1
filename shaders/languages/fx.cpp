#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "shaders/languages/hlsl.h"

namespace lumaknot::fx {
namespace {

/// The paper's names in Table 1; others as it would have named them.
std::string fx_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kTable1{
      {{"eye_position", "EyePos"},
       {"light_position", "LightPos"},
       {"ambient", "AmbientValue"},
       {"shininess", "SpecularPower"},
       {"color_texture", "ColorTexture"}}};
  const auto found =
      std::ranges::find(kTable1, name, &std::pair<std::string_view, std::string_view>::first);
  if (found != kTable1.end()) return std::string(found->second);
  std::string result;
  bool starts = true;
  for (const unsigned char c : name) {
    if (c != '_') result += char(starts ? std::toupper(c) : c);
    starts = c == '_';
  }
  return result;
}

/// HLSL's, with the paper's names for parameters.
constexpr Dialect fx_dialect() {
  Dialect dialect = kHlslDialect;
  dialect.parameter_name = fx_name;
  return dialect;
}
constexpr Dialect kDialect = fx_dialect();

std::string_view type_of(bool is_vector) { return is_vector ? "float3" : "float"; }

std::string id(std::string_view name) { return parameter_identifier(name, kDialect); }

/// light_position or light2_position: the number that SAS counts from 0.
int light_index(std::string_view name) {
  const std::string digits(name.substr(5, name.find('_') - 5));
  return digits.empty() ? 0 : std::stoi(digits) - 1;
}

/// The annotations of a place or direction of the scene.
std::string object_annotations(const ShaderParameter& p) {
  if (p.name == "eye_position") return "  string UIWidget = \"None\";\n";
  const std::string_view what = p.name.ends_with("position") ? "Position" : "Direction";
  const int index = light_index(p.name);
  return fmt::format(
      "  string UIName = \"Lamp {0} {1}\";\n"
      "  string Object = \"{2}Light{0}\";\n"
      "  string Space = \"World\";\n",
      index, what, what == "Position" ? "Point" : "Directional");
}

std::string slider_annotations(const ShaderParameter& p, const ParameterInfo& info) {
  const Interval<double> range = range_of(p);
  return fmt::format(
      "  string UIName = \"{}\";\n"
      "  string UIWidget = \"slider\";\n"
      "  float UIMin = {};\n"
      "  float UIMax = {};\n"
      "  float UIStep = {};\n",
      id(p.name), number_text(range.min), number_text(range.max), number_text(info.step));
}

std::string color_annotations(const ShaderParameter& p) {
  return fmt::format("  string UIName = \"{}\";\n  string UIWidget = \"Color\";\n", id(p.name));
}

std::string parameter_text(const ShaderParameter& p) {
  const ParameterInfo info = parameter_info(p.name);
  const bool is_place = p.name.ends_with("position") || p.name.ends_with("direction");
  const std::string semantic = info.semantic.empty() ? "" : fmt::format(" : {}", info.semantic);
  const std::string annotations = is_place      ? object_annotations(p)
                                  : p.is_vector ? color_annotations(p)
                                                : slider_annotations(p, info);
  return fmt::format("{}\n{} {}{} <\n{}> = {};\n\n", comment_of(p.name), type_of(p.is_vector),
                     id(p.name), semantic, annotations, literal(p, kDialect));
}

constexpr std::string_view kMatrices =
    "float4x4 WorldInverseTranspose : WorldInverseTranspose < string UIWidget = \"None\"; >;\n"
    "float4x4 WorldViewProjection : WorldViewProjection < string UIWidget = \"None\"; >;\n"
    "float4x4 World : World < string UIWidget = \"None\"; >;\n\n";

/// Round brackets about the texture's name: angle brackets mean the same, but not every compiler
/// reads them.
std::string texture_text(const Shader& shader) {
  if (!shader.textured()) return "";
  return fmt::format(
      "{2}\n"
      "texture {0} : DIFFUSE <\n"
      "  string ResourceName = \"default_color.dds\";\n"
      "  string UIName = \"{1}\";\n"
      "  string ResourceType = \"2D\";\n"
      ">;\n\n"
      "sampler2D ColorSampler = sampler_state {{\n"
      "  Texture = ({0});\n"
      "  FILTER = MIN_MAG_MIP_LINEAR;\n"
      "  AddressU = Wrap;\n"
      "  AddressV = Wrap;\n"
      "}};\n\n",
      id(texture_name(shader)),
      shader.baked ? "Texture on the axes of the space" : "Diffuse Texture",
      comment_of(texture_name(shader)));
}

std::string structure(const Shader& shader) {
  std::string text = "struct Surface {\n  float4 clip_position : POSITION;\n";
  int index = 0;
  for (const StageLink& link : stage_links(shader, kDialect)) {
    text += fmt::format("  {} {} : TEXCOORD{};\n", link.type, link.name, index++);
  }
  return text + "};\n\n";
}

std::string vertex_main(const Shader& shader) {
  std::string text =
      "Surface VertexMain(float3 vertex_position : POSITION, float2 vertex_uv : TEXCOORD0,\n"
      "                   float3 vertex_normal : NORMAL) {\n"
      "  Surface surface = (Surface)0;\n";
  if (shader.fragment.position || shader.vertex.position) {
    text += "  float3 position = mul(float4(vertex_position, 1.0), World).xyz;\n";
  }
  if (shader.fragment.normal || shader.vertex.normal) {
    text +=
        "  float3 normal = normalize(mul(float4(vertex_normal, 0.0), "
        "WorldInverseTranspose).xyz);\n";
  }
  if (shader.fragment.position) text += "  surface.position = position;\n";
  if (shader.fragment.normal) text += "  surface.normal = normal;\n";
  if (shader.textured()) text += "  surface.uv = vertex_uv;\n";
  for (const ShaderFunction& function : varying_functions(shader)) {
    const std::string call =
        call_text(function, kDialect, [](const auto& input) { return input.name; });
    text += fmt::format("  surface.{} = {};\n", varying_of(function), call);
  }
  return text +
         "  surface.clip_position = mul(float4(vertex_position, 1.0), WorldViewProjection);\n"
         "  return surface;\n}\n\n";
}

std::string pixel_main(const Shader& shader) {
  const std::string call = call_text(color_function(shader), kDialect, [](const auto& input) {
    return input.name.starts_with("texture") ? "tex2D(ColorSampler, surface.uv).rgb"
                                             : "surface." + input.name;
  });
  return fmt::format("float4 PixelMain(Surface surface) : COLOR {{\n{}}}\n\n",
                     wrapped_line(fmt::format("return float4({}, 1.0);", call), "  "));
}

/// Instruction slots that an operation takes at most.
int slots_of(const Node& node) {
  const bool constant_exponent = node.op == Op::kPower && node.arguments[1]->op == Op::kConstant;
  switch (node.op) {
    case Op::kInput:
    case Op::kParameter:
    case Op::kConstant:
    case Op::kX:
    case Op::kY:
    case Op::kZ:
    case Op::kGrey:
      return 0;
    case Op::kDivide:
    case Op::kSqrt:
    case Op::kExp:
    case Op::kLog:
    case Op::kCross:
      return 2;
    case Op::kCombine:
      return 3;
    case Op::kSelectLess:
      return 2;
    case Op::kUnit:
      return 4;
    case Op::kPower:
      return constant_exponent ? 3 : 6;
    default:
      return 1;
  }
}

int slots_of(const NodePtr& root) {
  int slots = 0;
  for (const Node* node : in_order({root})) slots += slots_of(*node);
  return slots;
}

constexpr int kModel2Slots = 64, kModel3Slots = 512;
constexpr int kMainSlots = 3;  // the texture's look-up, alpha, the output

/// Pixel shaders 2.0 have 64 slots for arithmetic.
bool needs_model_3(const Shader& shader) {
  return slots_of(shader.recorded.color) + kMainSlots > kModel2Slots;
}

std::string technique(const Shader& shader) {
  const std::string_view model = needs_model_3(shader) ? "3_0" : "2_0";
  return fmt::format(
      "technique {} < string Script = \"Pass=p0;\"; > {{\n"
      "  pass p0 < string Script = \"Draw=geometry;\"; > {{\n"
      "    VertexShader = compile vs_{} VertexMain();\n"
      "    ZEnable = true;\n"
      "    ZWriteEnable = true;\n"
      "    ZFunc = LessEqual;\n"
      "    AlphaBlendEnable = false;\n"
      "    CullMode = None;\n"
      "    PixelShader = compile ps_{} PixelMain();\n"
      "  }}\n}}\n",
      id(shader.function), model, model);
}

/// Says so when Direct3D 9 has too few instruction slots for the shader.
std::optional<std::string> shortfall(const Shader& shader) {
  std::vector<NodePtr> roots{shader.recorded.color};
  for (const Varying& varying : shader.recorded.varyings) roots.push_back(varying.value);
  for (const NodePtr& root : roots) {
    const int slots = slots_of(root) + kMainSlots;
    if (slots <= kModel3Slots) continue;
    return fmt::format(
        "fx: shader model 3 has {} instruction slots, {} may take {}; use fewer lights, or hlsl",
        kModel3Slots, shader.name, slots);
  }
  return std::nullopt;
}

std::vector<EmittedFile> emit(const Shader& shader) {
  std::string text = fmt::format("// {}.\n\n", about_of(shader));
  text += kMatrices;
  for (const ShaderParameter& p : shader.parameters) text += parameter_text(p);
  text += texture_text(shader) + structure(shader);
  text += with_helpers(
      vertex_functions(shader, kDialect) + function_text(color_function(shader), kDialect),
      kDialect);
  text += fmt::format("\n{}{}{}", vertex_main(shader), pixel_main(shader), technique(shader));
  return {{shader.name + ".fx", text}};
}

}  // namespace
}  // namespace lumaknot::fx

namespace lumaknot {

extern const Backend kFxBackend{.name = "fx",
                                .about = "Direct3D 9 effect as in the paper's Table 1, FX Composer",
                                .dialect = &fx::kDialect,
                                .emit = fx::emit,
                                .has_vertex_stage = true,
                                .shortfall = fx::shortfall};

}  // namespace lumaknot
