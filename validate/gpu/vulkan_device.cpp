#include "validate/gpu/vulkan_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "validate/gpu/unavailable.h"
#include "validate/gpu/vulkan_run.h"

namespace lumaknot::gpu {
namespace {

// Instances of 1.1 and later can ask for the driver's name; shaders stay with Vulkan 1.0.
constexpr std::uint32_t kApiVersion = VK_API_VERSION_1_2;

vk::raii::Instance make_instance(const vk::raii::Context& context) {
  const vk::ApplicationInfo application("lumaknot-gpu", 1, nullptr, 0, kApiVersion);
  try {
    return {context, vk::InstanceCreateInfo({}, &application)};
  } catch (const vk::IncompatibleDriverError&) {
    throw Unavailable("no Vulkan driver is installed; install one, such as Mesa's lavapipe");
  }
}

vk::raii::PhysicalDevice choose_device(const vk::raii::Instance& instance) {
  vk::raii::PhysicalDevices devices(instance);
  if (devices.empty()) throw Unavailable("no Vulkan device; install one, such as Mesa's lavapipe");
  const auto software = std::ranges::find_if(devices, [](const vk::raii::PhysicalDevice& device) {
    return device.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
  });
  return std::move(software != devices.end() ? *software : devices.front());
}

std::uint32_t graphics_family(const vk::raii::PhysicalDevice& physical) {
  const auto families = physical.getQueueFamilyProperties();
  for (std::uint32_t i = 0; i < families.size(); ++i) {
    if (families[i].queueFlags & vk::QueueFlagBits::eGraphics) return i;
  }
  throw Unavailable("the Vulkan device can't draw");
}

/// With bounds checks on buffers, where the device has them.
vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  vk::PhysicalDeviceFeatures features;
  features.robustBufferAccess = physical.getFeatures().robustBufferAccess;
  return {physical, vk::DeviceCreateInfo({}, queue, {}, {}, &features)};
}

/// The first memory type that a resource may use and that has the `wanted` properties.
std::uint32_t memory_type(const VulkanDevice& vulkan, std::uint32_t allowed,
                          vk::MemoryPropertyFlags wanted) {
  const auto memory = vulkan.physical.getMemoryProperties();
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    const bool fits = (memory.memoryTypes[i].propertyFlags & wanted) == wanted;
    if ((allowed >> i & 1u) && fits) return i;
  }
  throw Unavailable("the Vulkan device has no memory of the required type");
}

vk::raii::DeviceMemory allocate(const VulkanDevice& vulkan, const vk::MemoryRequirements& need,
                                vk::MemoryPropertyFlags wanted) {
  return {vulkan.device,
          vk::MemoryAllocateInfo(need.size, memory_type(vulkan, need.memoryTypeBits, wanted))};
}

vk::ImageAspectFlags aspect_of(vk::Format format) {
  return format == vk::Format::eD32Sfloat ? vk::ImageAspectFlagBits::eDepth
                                          : vk::ImageAspectFlagBits::eColor;
}

}  // namespace

VulkanDevice::VulkanDevice()
    : instance(make_instance(context)),
      physical(choose_device(instance)),
      family(graphics_family(physical)),
      device(make_device(physical, family)),
      queue(device, family, 0),
      commands(device,
               vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, family)) {}

Buffer make_buffer(const VulkanDevice& vulkan, vk::DeviceSize size, vk::BufferUsageFlags usage) {
  vk::raii::Buffer buffer(vulkan.device, vk::BufferCreateInfo({}, size, usage));
  vk::raii::DeviceMemory memory = allocate(
      vulkan, buffer.getMemoryRequirements(),
      vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
  buffer.bindMemory(*memory, 0);
  return {std::move(buffer), std::move(memory), size};
}

Buffer make_buffer(const VulkanDevice& vulkan, const void* from, vk::DeviceSize size,
                   vk::BufferUsageFlags usage) {
  Buffer buffer = make_buffer(vulkan, size, usage);
  std::memcpy(buffer.memory.mapMemory(0, size), from, size);
  buffer.memory.unmapMemory();
  return buffer;
}

void read_buffer(const Buffer& buffer, void* to) {
  std::memcpy(to, buffer.memory.mapMemory(0, buffer.size), buffer.size);
  buffer.memory.unmapMemory();
}

DeviceImage make_image(const VulkanDevice& vulkan, vk::Extent2D size, vk::Format format,
                       vk::ImageUsageFlags usage, const std::string& what) {
  const std::uint32_t max = vulkan.physical.getProperties().limits.maxImageDimension2D;
  if (std::max(size.width, size.height) > max) {
    throw Unavailable(fmt::format("{} has a side of {}, the device's limit is {}", what,
                                  std::max(size.width, size.height), max));
  }
  vk::raii::Image image(
      vulkan.device,
      vk::ImageCreateInfo({}, vk::ImageType::e2D, format, {size.width, size.height, 1}, 1, 1,
                          vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage));
  vk::raii::DeviceMemory memory =
      allocate(vulkan, image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
  image.bindMemory(*memory, 0);
  vk::raii::ImageView view(vulkan.device,
                           vk::ImageViewCreateInfo({}, *image, vk::ImageViewType::e2D, format, {},
                                                   {aspect_of(format), 0, 1, 0, 1}));
  return {std::move(image), std::move(memory), std::move(view)};
}

void submit(const VulkanDevice& vulkan,
            const std::function<void(const vk::raii::CommandBuffer&)>& record) {
  const vk::raii::CommandBuffers buffers(vulkan.device,
                                         {*vulkan.commands, vk::CommandBufferLevel::ePrimary, 1});
  const vk::raii::CommandBuffer& commands = buffers.front();
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  record(commands);
  commands.end();
  vulkan.queue.submit(vk::SubmitInfo({}, {}, *commands));
  vulkan.queue.waitIdle();
}

std::string vulkan_version() {
  const vk::raii::Context context;
  const vk::raii::Instance instance = make_instance(context);
  const vk::raii::PhysicalDevice physical = choose_device(instance);
  const auto properties = physical.getProperties();
  const std::string name = properties.deviceName;
  if (properties.apiVersion < VK_API_VERSION_1_2) {
    return fmt::format("{}, driver 0x{:x}", name, properties.driverVersion);
  }
  const auto driver =
      physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>()
          .get<vk::PhysicalDeviceDriverProperties>();
  return fmt::format("{}, {} {}", name, std::string(driver.driverName.data()),
                     std::string(driver.driverInfo.data()));
}

}  // namespace lumaknot::gpu
