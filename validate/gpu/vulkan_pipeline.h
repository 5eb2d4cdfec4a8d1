/// One draw's shaders, state and bindings on a Vulkan device.
#pragma once

#include <optional>
#include <vector>

#include "validate/gpu/vulkan_scene.h"

namespace lumaknot::gpu {

/// Descriptor set 0 with its contents: the job's textures and the draw's uniform block.
struct Bindings {
  std::optional<Buffer> uniform_block;
  vk::raii::DescriptorSetLayout set_layout;
  vk::raii::PipelineLayout layout;
  vk::raii::DescriptorPool pool;
  vk::raii::DescriptorSet set;
};

Bindings make_bindings(const VulkanDevice& vulkan, const Job& job, const Draw& draw,
                       const std::vector<SampledImage>& images);

/// Table 1's state: depth test "less or equal", depth written, no blending, no culling. Throws
/// Error or Unavailable as checked_spirv() does.
vk::raii::Pipeline make_pipeline(const VulkanDevice& vulkan, const Target& target,
                                 const Bindings& bindings, const Job& job, const Draw& draw);

}  // namespace lumaknot::gpu
