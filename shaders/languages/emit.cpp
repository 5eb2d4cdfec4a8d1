#include "shaders/languages/emit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "shaders/languages/common.h"
#include "system/error.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

Json entry_json(std::string_view name, std::string_view type, const Dialect& dialect) {
  const ParameterInfo info = parameter_info(name);
  Json json{{"name", name},
            {"identifier", dialect.parameter_name ? dialect.parameter_name(name) : name},
            {"type", type},
            {"meaning", info.meaning},
            {"unit", info.unit}};
  if (!info.semantic.empty()) json["semantic"] = info.semantic;
  return json;
}

Json parameter_json(const ShaderParameter& p, const Dialect& dialect) {
  Json json = entry_json(p.name, p.is_vector ? "vec3" : "float", dialect);
  json["identifier"] = parameter_identifier(p.name, dialect);
  json["default"] = p.is_vector ? Json(components(p.value)) : Json(p.value.x);
  const Interval<double> range = range_of(p);
  json["range"] = {range.min, range.max};
  return json;
}

/// What a program must set besides the parameters: matrices, the texture, the vertices.
void add_interface(Json& json, const Shader& shader, Language language, const Dialect& dialect) {
  if (!backend_of(language).has_vertex_stage) {
    for (const ShaderFunction::Input& input : color_function(shader).inputs) {
      json["inputs"].push_back({{"name", input.name},
                                {"identifier", identifier_of(input.name, dialect)},
                                {"type", "vec3"}});
    }
    return;
  }
  if (shader.textured()) {
    json["textures"].push_back(entry_json(texture_name(shader), "sampler2D", dialect));
  }
  for (const char* matrix : {"world", "world_inverse_transpose", "world_view_projection"}) {
    json["matrices"].push_back(entry_json(matrix, "mat4", dialect));
  }
  json["vertex"] = {{{"name", "position"}, {"type", "vec3"}, {"location", 0}},
                    {{"name", "normal"}, {"type", "vec3"}, {"location", 1}},
                    {{"name", "uv"}, {"type", "vec2"}, {"location", 2}}};
}

std::string parameters_json(const Shader& shader, Language language,
                            const std::vector<EmittedFile>& files) {
  const Dialect& dialect = dialect_of(language);
  Json json{{"shader", shader.name},
            {"language", backend_of(language).name},
            {"operations", operation_count(shader)},
            {"files", Json::array()},
            {"parameters", Json::array()}};
  for (const EmittedFile& file : files) json["files"].push_back(file.name);
  for (const BlockEntry& entry : parameter_block(shader)) {
    json["parameters"].push_back(parameter_json(entry.parameter, dialect));
    if (backend_of(language).has_block) json["parameters"].back()["offset"] = entry.offset;
  }
  add_interface(json, shader, language, dialect);
  return json.dump(2) + "\n";
}

}  // namespace

std::optional<std::string> emission_shortfall(const ShaderJob& job, Language language) {
  if (const auto why = language_shortfall(language, job.shot.material)) return why;
  const auto shortfall = backend_of(language).shortfall;
  return shortfall ? shortfall(make_shader(job)) : std::nullopt;
}

Emission emit(const ShaderJob& job, Language language) {
  if (const auto why = emission_shortfall(job, language)) throw Error(*why);
  const Shader shader = make_shader(job);
  Emission files = backend_of(language).emit(shader);
  files.push_back({"parameters.json", parameters_json(shader, language, files)});
  return files;
}

KernelCode emit_kernel(const Shader& shader, Language language) {
  const auto kernel = backend_of(language).kernel;
  assert(kernel);
  return kernel(shader);
}

std::vector<KernelInput> kernel_inputs(const Shader& shader) {
  std::vector<KernelInput> inputs{{"position"}, {"normal"}, {"texture"}};
  for (const ShaderParameter& p : shader.parameters) inputs.push_back({p.name, p.is_vector});
  return inputs;
}

std::vector<BlockEntry> parameter_block(const Shader& shader) {
  std::vector<BlockEntry> entries;
  int offset = kMatrixBytes;
  for (const ShaderParameter& p : shader.parameters) {
    if (p.is_vector) offset = (offset + 15) / 16 * 16;
    entries.push_back({p, offset});
    offset += p.is_vector ? 12 : 4;
  }
  return entries;
}

int operation_count(const Shader& shader) {
  std::vector<NodePtr> roots{shader.recorded.color};
  for (const Varying& varying : shader.recorded.varyings) roots.push_back(varying.value);
  return int(std::ranges::count_if(in_order(roots), [](const Node* node) {
    const bool only_moves = node->op == Op::kCombine || node->op == Op::kGrey ||
                            node->op == Op::kX || node->op == Op::kY || node->op == Op::kZ;
    return !node->arguments.empty() && !only_moves;
  }));
}

}  // namespace lumaknot
