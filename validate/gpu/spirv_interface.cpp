#include "validate/gpu/spirv_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <spirv_cross/spirv_cross.hpp>
#include <string_view>

#include "system/error.h"

namespace lumaknot::gpu {
namespace {

using spirv_cross::Compiler;
using List = spirv_cross::SmallVector<spirv_cross::Resource>;

constexpr std::array<std::string_view, 5> kKindNames{
    "a uniform block", "a texture with its sampler", "a texture", "a sampler", "something else"};

void add(std::vector<Resource>& resources, const Compiler& compiler, const List& list,
         ResourceKind kind) {
  for (const spirv_cross::Resource& found : list) {
    Resource resource{kind, compiler.get_decoration(found.id, spv::DecorationDescriptorSet),
                      compiler.get_decoration(found.id, spv::DecorationBinding), 0};
    if (kind == ResourceKind::kUniformBlock) {
      resource.size = compiler.get_declared_struct_size(compiler.get_type(found.base_type_id));
    }
    resources.push_back(resource);
  }
}

std::set<std::uint32_t> locations(const Compiler& compiler, const List& list) {
  std::set<std::uint32_t> all;
  for (const spirv_cross::Resource& found : list) {
    all.insert(compiler.get_decoration(found.id, spv::DecorationLocation));
  }
  return all;
}

void choose_entry(Compiler& compiler, const Shader& shader, Stage stage) {
  const auto model =
      stage == Stage::kVertex ? spv::ExecutionModelVertex : spv::ExecutionModelFragment;
  const auto entries = compiler.get_entry_points_and_stages();
  const bool there = std::ranges::any_of(entries, [&](const spirv_cross::EntryPoint& e) {
    return e.name == shader.entry && e.execution_model == model;
  });
  if (!there) {
    throw Error(fmt::format("{} has no {} entry point {}", shader.where,
                            stage == Stage::kVertex ? "vertex" : "fragment", shader.entry));
  }
  compiler.set_entry_point(shader.entry, model);
}

std::vector<Resource> resources_of(const Compiler& compiler,
                                   const spirv_cross::ShaderResources& found) {
  std::vector<Resource> all;
  add(all, compiler, found.uniform_buffers, ResourceKind::kUniformBlock);
  add(all, compiler, found.sampled_images, ResourceKind::kCombinedSampler);
  add(all, compiler, found.separate_images, ResourceKind::kTexture);
  add(all, compiler, found.separate_samplers, ResourceKind::kSampler);
  for (const List* list : {&found.storage_buffers, &found.storage_images, &found.subpass_inputs,
                           &found.push_constant_buffers}) {
    add(all, compiler, *list, ResourceKind::kOther);
  }
  return all;
}

/// The job's contents of descriptor set 0.
std::vector<Resource> given(const Job& job, const Draw& draw) {
  std::vector<Resource> all;
  for (const Texture& t : job.textures) {
    const bool combined = t.sampler < 0;
    all.push_back({combined ? ResourceKind::kCombinedSampler : ResourceKind::kTexture, 0,
                   std::uint32_t(t.binding), 0});
    if (!combined) all.push_back({ResourceKind::kSampler, 0, std::uint32_t(t.sampler), 0});
  }
  if (draw.uniform_block) {
    all.push_back({ResourceKind::kUniformBlock, 0, std::uint32_t(draw.uniform_binding),
                   draw.uniform_block->size()});
  }
  return all;
}

/// A texture with its sampler also serves a shader that declares one of the two, or both separately
/// at the same binding (Vulkan, "Shader Resource and Descriptor Type Correspondence").
bool fills(const Resource& resource, const Resource& wanted) {
  const bool part =
      resource.kind == ResourceKind::kCombinedSampler &&
      (wanted.kind == ResourceKind::kTexture || wanted.kind == ResourceKind::kSampler);
  return (part || resource.kind == wanted.kind) && resource.set == wanted.set &&
         resource.binding == wanted.binding;
}

}  // namespace

Interface interface_of(const Shader& shader, const std::vector<std::uint32_t>& words, Stage stage) {
  Compiler compiler(words);
  choose_entry(compiler, shader, stage);
  const auto used = compiler.get_shader_resources(compiler.get_active_interface_variables());
  return {resources_of(compiler, used), locations(compiler, used.stage_inputs),
          locations(compiler, used.stage_outputs)};
}

void check_resources(const Job& job, const Draw& draw, const Shader& shader,
                     const Interface& interface) {
  const std::vector<Resource> all = given(job, draw);
  for (const Resource& wanted : interface.resources) {
    const auto found =
        std::ranges::find_if(all, [&](const Resource& r) { return fills(r, wanted); });
    if (found == all.end()) {
      throw Error(fmt::format("{} uses {} at set {}, binding {}, where the job has none",
                              shader.where, kKindNames[std::size_t(wanted.kind)], wanted.set,
                              wanted.binding));
    }
    if (found->size < wanted.size) {
      throw Error(fmt::format("{}: uniform_block has {} bytes, {} reads {}", draw.where,
                              found->size, shader.where, wanted.size));
    }
  }
}

void check_locations(const Job& job, const Draw& draw, const Interface& vertex,
                     const Interface& fragment) {
  for (const std::uint32_t location : vertex.inputs) {
    if (job.mesh && location <= 2) continue;
    throw Error(fmt::format("{} reads the attribute at location {}, which {}", draw.vertex.where,
                            location, job.mesh ? "the mesh lacks" : "needs a mesh"));
  }
  if (!fragment.outputs.contains(0)) {
    throw Error(fmt::format("{} writes no colour to location 0", draw.fragment.where));
  }
  for (const std::uint32_t location : fragment.inputs) {
    if (vertex.outputs.contains(location)) continue;
    throw Error(fmt::format("{} reads location {}, which {} does not write", draw.fragment.where,
                            location, draw.vertex.where));
  }
}

}  // namespace lumaknot::gpu
