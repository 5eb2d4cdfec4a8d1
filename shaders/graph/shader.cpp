#include "shaders/graph/shader.h"

#include <algorithm>
#include <functional>

namespace lumaknot {
namespace {

void add_once(std::vector<ShaderParameter>& list, const ShaderParameter& parameter) {
  const auto same = [&](const ShaderParameter& p) { return p.name == parameter.name; };
  if (std::ranges::none_of(list, same)) list.push_back(parameter);
}

void vectors_first(std::vector<ShaderParameter>& list) {
  std::stable_partition(list.begin(), list.end(), std::mem_fn(&ShaderParameter::is_vector));
}

StageReads reads_of(const std::vector<NodePtr>& roots) {
  StageReads reads;
  for (const Node* node : in_order(roots)) {
    if (node->op == Op::kParameter) {
      add_once(reads.parameters, {node->name, node->is_vector, node->value});
    }
    if (node->op != Op::kInput) continue;
    reads.position |= node->name == "position";
    reads.normal |= node->name == "normal";
    reads.texture |= node->name.starts_with("texture");
  }
  vectors_first(reads.parameters);
  return reads;
}

}  // namespace

Shader make_shader(const ShaderJob& job) {
  Shader shader;
  shader.name = job.name;
  shader.function = job.name;
  std::ranges::replace(shader.function, '-', '_');
  shader.recorded = record_shot(job.view, job.shot, job.keep, job.color);
  shader.baked = job.shot.material.form == Form::kBaked;
  std::vector<NodePtr> varyings;
  varyings.reserve(shader.recorded.varyings.size());
  for (const Varying& varying : shader.recorded.varyings) varyings.push_back(varying.value);
  shader.vertex = reads_of(varyings);
  shader.fragment = reads_of({shader.recorded.color});
  shader.parameters = shader.vertex.parameters;
  for (const ShaderParameter& p : shader.fragment.parameters) add_once(shader.parameters, p);
  vectors_first(shader.parameters);
  return shader;
}

}  // namespace lumaknot
