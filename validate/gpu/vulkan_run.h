/// A job's pictures drawn by Vulkan.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// A device that holds the job's mesh, textures and target.
class VulkanRun {
 public:
  /// `job` must outlive it. Throws Unavailable or vk::Error.
  explicit VulkanRun(const Job& job);
  ~VulkanRun();
  VulkanRun(const VulkanRun&) = delete;
  VulkanRun& operator=(const VulkanRun&) = delete;

  /// The picture as RGBA floats, top row first. Throws Error if a shader is not a SPIR-V module,
  /// Unavailable if it is invalid or the device rejects it.
  std::vector<float> draw(const Draw& draw) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The device's name and its driver's version, on one line. Throws Unavailable or vk::Error.
std::string vulkan_version();

}  // namespace lumaknot::gpu
