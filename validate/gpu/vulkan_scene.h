/// The resources that all draws of a job share on a Vulkan device.
#pragma once

#include <optional>
#include <vector>

#include "validate/gpu/job.h"
#include "validate/gpu/vulkan_device.h"

namespace lumaknot::gpu {

inline constexpr vk::Format kColorFormat = vk::Format::eR32G32B32A32Sfloat;
inline constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;

/// The colour and depth images, cleared at each pass, and a buffer to read the colours back.
struct Target {
  vk::Extent2D size;
  DeviceImage color, depth;
  vk::raii::RenderPass pass;
  vk::raii::Framebuffer framebuffer;
  Buffer pixels;
};

/// A texture on the device and how it is looked up.
struct SampledImage {
  DeviceImage image;
  vk::raii::Sampler sampler;
};

struct MeshBuffers {
  Buffer vertices, indices;
};

Target make_target(const VulkanDevice& vulkan, const Job& job);

std::vector<SampledImage> upload_textures(const VulkanDevice& vulkan, const Job& job);

std::optional<MeshBuffers> upload_mesh(const VulkanDevice& vulkan, const Job& job);

}  // namespace lumaknot::gpu
