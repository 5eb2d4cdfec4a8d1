/// A Vulkan device and its memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace lumaknot::gpu {

/// A device with one graphics queue. A software device is preferred: it draws the same picture
/// everywhere.
struct VulkanDevice {
  vk::raii::Context context;
  vk::raii::Instance instance;
  vk::raii::PhysicalDevice physical;
  std::uint32_t family = 0;  ///< of the queue
  vk::raii::Device device;
  vk::raii::Queue queue;
  vk::raii::CommandPool commands;

  /// Throws Unavailable or vk::Error.
  VulkanDevice();
};

/// Host-visible memory.
struct Buffer {
  vk::raii::Buffer buffer;
  vk::raii::DeviceMemory memory;
  vk::DeviceSize size = 0;  ///< bytes
};

/// An image in the device's memory, its layout undefined.
struct DeviceImage {
  vk::raii::Image image;
  vk::raii::DeviceMemory memory;
  vk::raii::ImageView view;
};

Buffer make_buffer(const VulkanDevice& vulkan, vk::DeviceSize size, vk::BufferUsageFlags usage);

/// A buffer that holds the `size` bytes at `from`.
Buffer make_buffer(const VulkanDevice& vulkan, const void* from, vk::DeviceSize size,
                   vk::BufferUsageFlags usage);

/// Copies the buffer's bytes to `to`.
void read_buffer(const Buffer& buffer, void* to);

/// Throws Unavailable if the image is larger than the device allows; `what` names it.
DeviceImage make_image(const VulkanDevice& vulkan, vk::Extent2D size, vk::Format format,
                       vk::ImageUsageFlags usage, const std::string& what);

/// Records commands, runs them and waits until they finish.
void submit(const VulkanDevice& vulkan,
            const std::function<void(const vk::raii::CommandBuffer&)>& record);

}  // namespace lumaknot::gpu
